// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input.h"
#include "text.h"
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace posture {

/// Goes through the words of a file from left to right; failures name the line.
class TextReader {
 public:
  /// \param offset   where to begin; at 0 a byte-order mark is skipped.
  /// \param comment  starts a comment that ends with the line; '\0': no comments.
  explicit TextReader(const Input& input, std::size_t offset = 0, char comment = '\0')
      : input_(input),
        text_(input.bytes()),
        offset_(offset == 0 ? textBegin(text_) : offset),
        comment_(comment) {}

  /// The next word on this line or a later one; empty at the end of the file.
  std::string_view word();
  /// The next word on this line; empty at its end.
  std::string_view wordOnLine();
  /// Whether nothing more than blanks and a comment is on this line.
  bool isAtLineEnd();
  /// Leaves this line and any blank ones after it; false at the end of the file.
  bool nextLine();
  /// Whether nothing is left but blank lines, comments and what pads files: zeros, or the
  /// end-of-file mark of DOS.
  bool atEnd();
  /// The next `count` bytes as they are. \pre count <= remaining()
  std::string_view bytes(std::size_t count);
  /// Steps behind the end of this line, no further.
  void skipLine();

  /// Of a word that is missing `what` is named.
  double number(std::string_view word, const char* what) const;
  std::int64_t integer(std::string_view word, const char* what) const;
  double number(const char* what) { return number(word(), what); }
  std::int64_t integer(const char* what) { return integer(word(), what); }
  /// A number of things that still have to come, `smallest` bytes or more each.
  std::size_t count(std::string_view word, std::size_t smallest, const char* what) const;

  std::size_t offset() const { return offset_; }
  std::size_t remaining() const { return text_.size() - offset_; }
  void moveTo(std::size_t offset) { offset_ = offset; }
  /// For a file with binary parts, where counting lines means nothing.
  void nameNoLines() { names_lines_ = false; }
  [[noreturn]] void fail(const std::string& what) const {
    input_.failAt(names_lines_ ? offset_ : NO_OFFSET, what);
  }

 private:
  void skipBlanks();

  const Input& input_;
  std::string_view text_;
  std::size_t offset_;
  char comment_;
  bool names_lines_ = true;
};

/// The whole of `word` as a decimal number; false where it is none. Too large a number is infinite.
bool parseNumber(std::string_view word, double& value);
bool parseInteger(std::string_view word, std::int64_t& value);

/// False where `value` is no whole number, or too large for an index by far.
bool toWhole(double value, std::int64_t& whole);

/// ASCII letters made small.
std::string lowercase(std::string_view text);

}  // namespace posture
