// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "run_progress.h"

#include <posture/core/seconds_since.h>
#include <posture/report/table.h>

#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace posture::app {

RunProgress::RunProgress(bool quiet, std::size_t runs)
    : silent_(quiet), live_(!quiet && isatty(STDERR_FILENO) != 0), runs_(runs) {}

void RunProgress::begin(const std::string& name) {
  ++run_;
  name_ = name;
  start_ = std::chrono::steady_clock::now();
}

void RunProgress::wait() const {
  if (!live_) return;
  std::fprintf(stderr, "\r\033[K%s  %.0f s", head().c_str(), secondsSince(start_));
}

void RunProgress::end(const Json& result) const {
  if (silent_) return;
  std::string line = head() + "  " + result.value("status", "");
  const double error = numberAt(result, "/errors/mean_x100");
  const double seconds = numberAt(result, "/seconds");
  if (std::isfinite(error)) line += ", mean error " + formatFixed(error, 2);
  if (std::isfinite(seconds)) line += ", " + formatFixed(seconds, 1) + " s";
  const std::string message = result.value("message", "");
  if (!message.empty()) line += " (" + message + ")";
  std::fprintf(stderr, "%s%s\n", live_ ? "\r\033[K" : "", line.c_str());
}

std::string RunProgress::head() const {
  return "[" + std::to_string(run_) + "/" + std::to_string(runs_) + "] " + name_;
}

}  // namespace posture::app
