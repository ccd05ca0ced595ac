// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace posture {

/// An attempt finds too little to go on with: no fault of the data, another one may find more.
class NoWayOn : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace posture
