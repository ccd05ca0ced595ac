// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_document.h"
#include <chrono>
#include <string>

namespace posture::app {

/// Says on stderr how far a list of runs is: one line that changes on a terminal, one line a run
/// elsewhere.
class RunProgress {
 public:
  RunProgress(bool quiet, std::size_t runs);

  void begin(const std::string& name);
  void wait() const;
  /// \param result  status, seconds, errors and message as far as it has them.
  void end(const Json& result) const;

 private:
  std::string head() const;

  bool silent_, live_;
  std::size_t runs_;
  std::size_t run_ = 0;
  std::string name_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace posture::app
