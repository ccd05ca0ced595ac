// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/pipeline/observer.h>

namespace posture {

std::string stageTitle(std::string_view attempt, std::string_view stage) {
  std::string title(attempt);
  if (!title.empty()) title += ' ';
  return title += stage;
}

}  // namespace posture
