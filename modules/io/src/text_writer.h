// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <string>

namespace posture {

/// The shortest text that reads back as the same number, whatever the locale.
template <class T>
void appendNumber(std::string& text, T value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// `separator` before each but the first.
template <class First, class... Rest>
void appendNumbers(std::string& text, char separator, First first, Rest... rest) {
  appendNumber(text, first);
  ((text += separator, appendNumber(text, rest)), ...);
}

}  // namespace posture
