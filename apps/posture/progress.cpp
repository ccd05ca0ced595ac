// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace posture::app {

ProgressBar::ProgressBar(bool quiet) : active_(!quiet && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::show(std::string_view stage, double progress) {
  if (!active_) return;
  constexpr int WIDTH = 30;
  const int filled = static_cast<int>(std::clamp(progress, 0.0, 1.0) * WIDTH);
  const std::string bar = std::string(filled, '#') + std::string(WIDTH - filled, '.');
  std::fprintf(stderr,
               "\r[%s] %3d%% %-16.*s",
               bar.c_str(),
               static_cast<int>(100 * progress),
               static_cast<int>(stage.size()),
               stage.data());
  std::fflush(stderr);
  drawn_ = true;
}

void ProgressBar::clear() {
  if (drawn_) std::fprintf(stderr, "\r\033[K");
  drawn_ = false;
}

}  // namespace posture::app
