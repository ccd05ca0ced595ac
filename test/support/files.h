// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/error.h>

#include <filesystem>
#include <string>
#include <vector>

namespace posture::test {

/// A folder of its own that ends with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file into the folder.
  std::filesystem::path file(const std::string& name, const std::string& bytes) const;
  /// Names of what is in it, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// Empty where there is no such file.
std::string bytesOf(const std::filesystem::path& path);

/// The message of the InputError that `action` throws; empty where it throws none.
template <class Action>
std::string inputErrorOf(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace posture::test
