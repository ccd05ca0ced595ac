// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace posture {

/// Whether the byte goes on with a character that began before it.
inline bool isContinuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
}

/// Bytes of the character that begins there; 0: none does, or not all of it is there (RFC 3629).
inline std::size_t characterLength(std::string_view text, std::size_t place) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[place + k]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4) return 0;
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (place + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!isContinuation(text[place + k])) return 0;
  // What a shorter sequence says, halves of pairs of UTF-16, and what lies beyond Unicode.
  const unsigned char second = byte(1);
  if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0) ||
      (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second >= 0x90))
    return 0;
  return length;
}

inline bool isUtf8(std::string_view text) {
  for (std::size_t i = 0, length = 0; i < text.size(); i += length) {
    length = characterLength(text, i);
    if (length == 0) return false;
  }
  return true;
}

}  // namespace posture
