// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace posture::app {

/// A bar with the stage's name on stderr; nothing at all when that is not a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// \param progress  in [0, 1]
  void show(std::string_view stage, double progress);
  void clear();

 private:
  bool active_;
  bool drawn_ = false;
};

}  // namespace posture::app
