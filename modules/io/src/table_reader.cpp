// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "readers.h"
#include "table_layout.h"
#include "text.h"
#include "text_reader.h"
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace posture {
namespace {

bool isSeparator(char c) { return c == ',' || c == ';'; }

/// Behind a quoted text that begins a word at `at`, a quote doubled within it; `at` where none
/// does.
std::size_t behindQuotes(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != '"') return at;
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] != '"') continue;
    if (i + 1 == text.size() || text[i + 1] != '"') return i + 1;
    ++i;
  }
  return at;
}

/// The part of a line before a comment; `comment` is what stands behind the sign.
std::string_view withoutComment(std::string_view line, std::string_view& comment) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i == 0 || isBlank(line[i - 1]) || isSeparator(line[i - 1])) i = behindQuotes(line, i);
    if (i == line.size()) break;
    const std::size_t sign = line[i] == '#' ? 1 : line.substr(i, 2) == "//" ? 2 : 0;
    if (sign == 0) continue;
    comment = trimmed(line.substr(i + sign));
    return trimmed(line.substr(0, i));
  }
  comment = {};
  return trimmed(line);
}

/// What separates words: a comma or semicolon with or without blanks around it, and else blanks.
enum class Blanks { SEPARATE, BELONG };

/// What is in quotes, without them; else the word.
std::string_view unquoted(std::string_view word) {
  const bool is_quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
  return is_quoted ? trimmed(word.substr(1, word.size() - 2)) : word;
}

/// Between two separators an empty word, none behind the last. What is in quotes is not split.
void split(std::string_view text, Blanks blanks, std::vector<std::string_view>& words) {
  words.clear();
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t begin = at;
    at = behindQuotes(text, at);
    while (at < text.size() && !isSeparator(text[at]) &&
           (blanks == Blanks::BELONG || !isBlank(text[at])))
      ++at;
    words.push_back(unquoted(trimmed(text.substr(begin, at - begin))));
    while (at < text.size() && isBlank(text[at])) ++at;
    if (at < text.size() && isSeparator(text[at])) ++at;
    while (at < text.size() && isBlank(text[at])) ++at;
  }
}

/// A comma inside a number where something else separates the numbers.
bool hasDecimalCommas(std::string_view text) {
  const auto digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  bool comma_inside = false, other_separator = false;
  for (std::size_t i = 1; i < text.size(); ++i) {
    comma_inside = comma_inside || (text[i] == ',' && digit(i - 1) && digit(i + 1));
    const bool blank_between = isBlank(text[i]) && !isBlank(text[i - 1]) && text[i - 1] != ',' &&
                               trimmed(text.substr(i)).front() != ',';
    other_separator = other_separator || text[i] == ';' || blank_between;
  }
  return comma_inside && other_separator;
}

ColumnMeaning meaningOfEnding(const Input& input) {
  const std::string ending = lowercase(input.path().extension().string());
  return ending == ".xyzn"     ? ColumnMeaning::NORMAL
         : ending == ".xyzrgb" ? ColumnMeaning::COLOR
                               : ColumnMeaning::UNKNOWN;
}

class TableReader {
 public:
  explicit TableReader(const Input& input) : input_(input) {}

  PointCloud read() {
    const std::string_view bytes = input_.bytes();
    std::size_t begin = textBegin(bytes);
    while (begin < bytes.size()) {
      // CR, LF or both: between the two of Windows is a blank line.
      std::size_t end = begin;
      while (end < bytes.size() && bytes[end] != '\n' && bytes[end] != '\r') ++end;
      offset_ = begin;
      readLine(bytes.substr(begin, end - begin));
      begin = end + 1;
    }
    return finish();
  }

 private:
  void readLine(std::string_view line) {
    std::string_view comment;
    const std::string_view text = withoutComment(line, comment);
    if (columns_ == 0 && readNames(text.empty() ? comment : text, text.empty())) return;
    if (text.empty()) return;
    const bool is_apart = splitRow(text);
    if (readCount()) return;
    if (columns_ == 0) {
      if (!is_apart && hasDecimalCommas(text)) failDecimalCommas();
      begin();
    }
    if (lacksLast(columns_, text)) words_.emplace_back();
    if (static_cast<int>(words_.size()) != columns_) failRow(text);
    for (int column = 0; column < columns_; ++column) {
      double value = std::numeric_limits<double>::quiet_NaN();
      const std::string_view word = words_[static_cast<std::size_t>(column)];
      if (isNeeded(column) && !word.empty() && !parseNumber(word, value)) failNumber(word);
      numbers_.push_back(value);
    }
  }

  /// Only before the first row. Names on a line of their own are worth more than a comment.
  bool readNames(std::string_view text, bool in_comment) {
    split(text, Blanks::BELONG, words_);
    const bool are_apart = layoutOfNames(words_).has_value();
    if (!are_apart) split(text, Blanks::SEPARATE, words_);
    const auto is_unit = [](std::string_view word) {
      return !word.empty() && (word[0] == '(' || word[0] == '[');
    };
    words_.erase(std::remove_if(words_.begin(), words_.end(), is_unit), words_.end());
    // "Points: x y z" introduces the names; the colon is of no column.
    if (in_comment && !words_.empty() && words_[0].size() > 1 && words_[0].back() == ':')
      words_.erase(words_.begin());
    const std::optional<TableLayout> layout = layoutOfNames(words_);
    if (namesLackZ(words_)) {
      if (!in_comment) failWithoutZ();
      columns_without_z_ = static_cast<int>(words_.size());
    }
    if (!layout || (layout_ && in_comment)) return false;
    layout_ = layout;
    names_in_comment_ = in_comment;
    names_are_apart_ = are_apart;
    columns_of_names_ = static_cast<int>(words_.size());
    return true;
  }

  /// Where commas or semicolons separate the names, a text in a row may have blanks in it.
  /// \return  whether the row is separated as the names are.
  bool splitRow(std::string_view text) {
    if (layout_ && names_are_apart_) {
      split(text, Blanks::BELONG, words_);
      if (static_cast<int>(words_.size()) == columns_of_names_ ||
          lacksLast(columns_of_names_, text))
        return true;
    }
    split(text, Blanks::SEPARATE, words_);
    return false;
  }

  /// Nothing behind the last separator is an empty word.
  bool lacksLast(int columns, std::string_view text) const {
    return static_cast<int>(words_.size()) == columns - 1 && isSeparator(text.back());
  }

  /// The number of rows that follow, alone on its line: before the first one, or (as PTS files of
  /// several scans have it) when as many are there as were said before.
  bool readCount() {
    if (words_.size() != 1 || (columns_ != 0 && rows() != declared_)) return false;
    std::int64_t count = 0;
    if (!parseInteger(words_[0], count) || count < 0 || count > MOST_ROWS) return false;
    if (columns_ == 0 && declared_) input_.failAt(offset_, "a second number of points");
    declared_ = declared_.value_or(0) + count;
    return true;
  }

  void begin() {
    const auto count = static_cast<int>(words_.size());
    // A comment may speak of x, y and z without naming the columns.
    if (layout_ && names_in_comment_ && columns_of_names_ != count) layout_.reset();
    columns_ = layout_ ? columns_of_names_ : count;
    if (!layout_ && columns_without_z_ == count) failWithoutZ();
    if (layout_ || count >= 3) return;
    double ignored = 0;
    for (const std::string_view word : words_)
      if (!parseNumber(word, ignored)) failNumber(word);
    input_.failAt(
        offset_,
        "fewer than three numbers: a point is x y z, separated by blanks, tabs, commas or "
        "semicolons");
  }

  bool isNeeded(int column) const {
    if (!layout_) return true;
    for (const TableLayout::Columns* part : {&layout_->position, &layout_->normal, &layout_->color})
      for (const int needed : *part)
        if (needed == column) return true;
    return false;
  }

  [[noreturn]] void failNumber(std::string_view word) const {
    double ignored = 0;
    const std::size_t comma = word.find(',');
    if (comma != std::string_view::npos && parseNumber(word.substr(0, comma), ignored) &&
        parseNumber(word.substr(comma + 1), ignored))
      failDecimalCommas();
    input_.failAt(offset_, inQuotes(word) + " is not a number");
  }

  [[noreturn]] void failRow(std::string_view text) const {
    if (hasDecimalCommas(text)) failDecimalCommas();
    input_.failAt(offset_,
                  std::to_string(words_.size()) + " columns where " + std::to_string(columns_) +
                      " are expected (truncated?)");
  }

  [[noreturn]] void failWithoutZ() const {
    input_.failAt(offset_, "columns x and y are named, and none z");
  }

  [[noreturn]] void failDecimalCommas() const {
    input_.failAt(offset_, "decimal commas cannot be read, write decimal points");
  }

  std::int64_t rows() const {
    return columns_ == 0 ? 0 : static_cast<std::int64_t>(numbers_.size()) / columns_;
  }

  PointCloud finish() const {
    if (columns_ == 0) input_.fail("there are no points in it");
    if (rows() > MOST_ROWS) input_.fail("more points than can be numbered");
    if (declared_ && *declared_ != rows())
      input_.fail("it says " + std::to_string(*declared_) + " points and has " +
                  std::to_string(rows()) + " (truncated?)");
    return toCloud(
        numbers_,
        columns_,
        layout_ ? *layout_ : layoutOfNumbers(numbers_, columns_, meaningOfEnding(input_)));
  }

  static constexpr std::int64_t MOST_ROWS = std::numeric_limits<int>::max() - 1;

  const Input& input_;
  std::size_t offset_ = 0;  // of the line
  std::vector<std::string_view> words_;
  std::optional<TableLayout> layout_;
  bool names_in_comment_ = false, names_are_apart_ = false;  // by commas or semicolons
  int columns_of_names_ = 0, columns_without_z_ = 0;
  int columns_ = 0;  // 0: no row yet
  std::optional<std::int64_t> declared_;
  std::vector<double> numbers_;
};

}  // namespace

PointCloud readTable(const Input& input) { return TableReader(input).read(); }

}  // namespace posture
