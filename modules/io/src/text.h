// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace posture {

/// Where the text of a file begins: behind a UTF-8 byte-order mark.
inline std::size_t textBegin(std::string_view bytes) {
  constexpr std::string_view BYTE_ORDER_MARK = "\xef\xbb\xbf";
  return bytes.substr(0, BYTE_ORDER_MARK.size()) == BYTE_ORDER_MARK ? BYTE_ORDER_MARK.size() : 0;
}

/// What separates the words of a line; the first half of a Windows line end too.
constexpr bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

/// Whether bytes behind the data of a binary file say nothing: programs end it with a line, or
/// (PCL before 1.9) with zeros up to a page.
inline bool isPadding(std::string_view bytes) {
  return std::all_of(
      bytes.begin(), bytes.end(), [](char c) { return c == '\0' || c == '\n' || isBlank(c); });
}

}  // namespace posture
