// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/text_file.h>

#include "input.h"
#include "text.h"

namespace posture {

std::string readTextFile(const std::filesystem::path& path) {
  const Input input(path);
  return std::string(input.bytes().substr(textBegin(input.bytes())));
}

}  // namespace posture
