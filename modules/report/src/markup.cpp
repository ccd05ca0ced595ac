// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markup.h"

#include <posture/report/table.h>

#include <cmath>

namespace posture {
namespace {

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// Bytes of the character that begins at `place`; 0 where there is none.
std::size_t characterLength(const std::string& text, std::size_t place) {
  const auto lead = static_cast<unsigned char>(text[place]);
  std::size_t length = 0;
  if (lead < 0x80)
    length = 1;
  else if (lead >= 0xC2 && lead < 0xF5)
    length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (place + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!isContinuation(text[place + k])) return 0;
  return length;
}

std::string escapedCharacter(const std::string& character) {
  const char c = character.front();
  if (c == '&') return "&amp;";
  if (c == '<') return "&lt;";
  if (c == '>') return "&gt;";
  if (c == '"') return "&quot;";
  if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) return " ";
  return character;
}

}  // namespace

std::string escapedMarkup(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = characterLength(text, i);
    result += length == 0 ? "?" : escapedCharacter(text.substr(i, length));
    i += length == 0 ? 1 : length;
  }
  return result;
}

std::string coordinate(double value) {
  std::string text = formatFixed(value, 2);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace posture
