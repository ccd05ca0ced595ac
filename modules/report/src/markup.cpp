// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markup.h"

#include <posture/core/utf8.h>
#include <posture/report/table.h>

#include <cmath>

namespace posture {
namespace {

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
