// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace posture {

/// The data that were handed in cannot be used: a file that is missing or damaged, a mesh without
/// faces. The message is one line that names the file or shape and what is wrong with it.
/// A caller's mistake (a matrix of the wrong shape) is a std::invalid_argument instead.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws std::invalid_argument with `message` unless `condition` holds.
inline void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

/// What work on a file or shape gives; what it throws begins with the name.
template <class Work>
auto naming(const std::string& name, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(name + " " + error.what());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + " " + error.what());
  }
}

}  // namespace posture
