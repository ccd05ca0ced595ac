// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/peak_memory.h>

#include <fstream>
#include <string>

namespace posture {

long peakMemoryBytes() {
  // Not getrusage(): a program started by another inherits that one's peak.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return 1024 * std::stol(line.substr(6));
  return 0;
}

double peakMemoryMib() { return static_cast<double>(peakMemoryBytes()) / (1024 * 1024); }

}  // namespace posture
