// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/text_file.h>

#include "input.h"

namespace posture {

std::string readTextFile(const std::filesystem::path& path) {
  return std::string(Input(path).bytes());
}

}  // namespace posture
