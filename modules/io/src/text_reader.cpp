// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace posture {
namespace {

std::string_view withoutPlus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return plus ? word.substr(1) : word;
}

/// Of a number too large or too small for a double: is it the latter?
bool isBelowOne(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  if (exponent != std::string_view::npos) return word.find('-', exponent) == exponent + 1;
  return word.find_first_of("123456789") > word.find('.');
}

}  // namespace

bool parseNumber(std::string_view word, double& value) {
  word = withoutPlus(word);
  const char* const end = word.data() + word.size();
  auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range) {
    value = isBelowOne(word) ? 0 : std::numeric_limits<double>::infinity();
    error = std::errc();
  }
  return error == std::errc() && stop == end;
}

bool parseInteger(std::string_view word, std::int64_t& value) {
  word = withoutPlus(word);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end;
}

bool toWhole(double value, std::int64_t& whole) {
  constexpr double LARGEST = 1e15;
  if (!(std::abs(value) < LARGEST) || value != std::floor(value)) return false;
  whole = static_cast<std::int64_t>(value);
  return true;
}

std::string lowercase(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

bool TextReader::atEnd() {
  constexpr char DOS_END_OF_FILE = '\x1a';
  const auto pads = [](char c) { return c == '\0' || c == DOS_END_OF_FILE; };
  std::string_view rest = word();
  while (!rest.empty() && std::all_of(rest.begin(), rest.end(), pads)) rest = word();
  return rest.empty();
}

void TextReader::skipBlanks() {
  while (offset_ < text_.size() && isBlank(text_[offset_])) ++offset_;
  if (comment_ != '\0' && offset_ < text_.size() && text_[offset_] == comment_)
    while (offset_ < text_.size() && text_[offset_] != '\n') ++offset_;
}

std::string_view TextReader::wordOnLine() {
  skipBlanks();
  const std::size_t begin = offset_;
  while (offset_ < text_.size()) {
    const char c = text_[offset_];
    if (isBlank(c) || c == '\n' || (comment_ != '\0' && c == comment_)) break;
    ++offset_;
  }
  return text_.substr(begin, offset_ - begin);
}

std::string_view TextReader::word() {
  skipBlanks();
  while (offset_ < text_.size() && text_[offset_] == '\n') {
    ++offset_;
    skipBlanks();
  }
  return wordOnLine();
}

bool TextReader::isAtLineEnd() {
  skipBlanks();
  return offset_ == text_.size() || text_[offset_] == '\n';
}

void TextReader::skipLine() {
  const std::size_t end = text_.find('\n', offset_);
  offset_ = end == std::string_view::npos ? text_.size() : end + 1;
}

bool TextReader::nextLine() {
  skipLine();
  skipBlanks();
  while (offset_ < text_.size() && text_[offset_] == '\n') {
    ++offset_;
    skipBlanks();
  }
  return offset_ < text_.size();
}

std::string_view TextReader::bytes(std::size_t count) {
  const std::string_view taken = text_.substr(offset_, count);
  offset_ += count;
  return taken;
}

double TextReader::number(std::string_view word, const char* what) const {
  if (word.empty())
    fail(std::string(what) + " is missing" + (remaining() == 0 ? " (truncated)" : ""));
  double value = 0;
  if (!parseNumber(word, value))
    fail(std::string(what) + ": " + inQuotes(word) + " is not a number");
  return value;
}

std::int64_t TextReader::integer(std::string_view word, const char* what) const {
  if (word.empty())
    fail(std::string(what) + " is missing" + (remaining() == 0 ? " (truncated)" : ""));
  std::int64_t value = 0;
  if (!parseInteger(word, value))
    fail(std::string(what) + ": " + inQuotes(word) + " is not a whole number");
  return value;
}

std::size_t TextReader::count(std::string_view word, std::size_t smallest, const char* what) const {
  const std::int64_t value = integer(word, what);
  if (value < 0) fail(std::string(what) + " is negative: " + std::to_string(value));
  // The last number of a text file needs no blank behind it.
  if (static_cast<std::uint64_t>(value) > (remaining() + 1) / smallest)
    fail(std::string(what) + " is " + std::to_string(value) +
         ", too many for the size of the file (truncated?)");
  return static_cast<std::size_t>(value);
}

}  // namespace posture
