// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/utf8.h>
#include <posture/report/table.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace posture {
namespace {

struct Column {
  std::size_t width = 0;
  bool numbers = true;
};

/// Characters, not bytes, of UTF-8.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !isContinuation(c); }));
}

/// Digits with what stands around them in a table: signs, units of a percentage, "-" for none.
bool looksNumeric(const std::string& text) {
  if (text.empty() || text == "-") return true;
  double value = 0;
  const char* end = text.data() + text.size();
  const char* begin = text.data() + (text.front() == '+' ? 1 : 0);
  const auto parsed = std::from_chars(begin, end, value);
  const std::string rest(parsed.ptr, end);
  return parsed.ec == std::errc() && (rest.empty() || rest == "%" || rest == " %");
}

const std::string& cell(const std::vector<std::string>& row, std::size_t column) {
  static const std::string NOTHING;
  return column < row.size() ? row[column] : NOTHING;
}

void checkRows(const TextTable& table) {
  for (const auto& row : table.rows)
    require(row.size() <= table.header.size(),
            "a table's row has " + std::to_string(row.size()) + " cells, its header " +
                std::to_string(table.header.size()));
}

std::vector<Column> measure(const TextTable& table) {
  checkRows(table);
  std::vector<Column> columns(table.header.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    columns[c].width = width(table.header[c]);
    columns[c].numbers = !table.rows.empty();
    for (const auto& row : table.rows) {
      columns[c].width = std::max(columns[c].width, width(cell(row, c)));
      columns[c].numbers = columns[c].numbers && looksNumeric(cell(row, c));
    }
  }
  return columns;
}

std::string padded(const std::string& text, const Column& column) {
  const std::string blanks(column.width - width(text), ' ');
  return column.numbers ? blanks + text : text + blanks;
}

std::string textLine(const std::vector<std::string>& row, const std::vector<Column>& columns) {
  std::string line;
  for (std::size_t c = 0; c < columns.size(); ++c)
    line += (c > 0 ? "  " : "") + padded(cell(row, c), columns[c]);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string markdownLine(const std::vector<std::string>& row, const std::vector<Column>& columns) {
  std::string line = "|";
  for (std::size_t c = 0; c < columns.size(); ++c)
    line += " " + padded(cell(row, c), columns[c]) + " |";
  return line + "\n";
}

std::string escapedForMarkdown(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result;
}

std::string quotedForCsv(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

template <typename Change>
TextTable changed(const TextTable& table, Change change) {
  TextTable result = table;
  for (std::string& text : result.header) text = change(text);
  for (auto& row : result.rows)
    for (std::string& text : row) text = change(text);
  return result;
}

std::string format(double value, std::chars_format style, int digits) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 512> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, style, digits).ptr;
  return {text.data(), end};
}

}  // namespace

std::string toText(const TextTable& table) {
  const std::vector<Column> columns = measure(table);
  std::string text = textLine(table.header, columns);
  for (const auto& row : table.rows) text += textLine(row, columns);
  return text;
}

std::string toMarkdown(const TextTable& table) {
  const TextTable escaped = changed(table, escapedForMarkdown);
  std::vector<Column> columns = measure(escaped);
  for (Column& column : columns) column.width = std::max<std::size_t>(column.width, 3);
  std::string text = markdownLine(escaped.header, columns) + "|";
  for (const Column& column : columns)
    text += " " + std::string(column.width - 1, '-') + (column.numbers ? ":" : "-") + " |";
  text += "\n";
  for (const auto& row : escaped.rows) text += markdownLine(row, columns);
  return text;
}

std::string toCsv(const TextTable& table) {
  checkRows(table);
  std::string text;
  const auto append = [&](const std::vector<std::string>& row) {
    for (std::size_t c = 0; c < table.header.size(); ++c)
      text += (c > 0 ? "," : "") + quotedForCsv(cell(row, c));
    text += "\n";
  };
  append(table.header);
  for (const auto& row : table.rows) append(row);
  return text;
}

std::string formatFixed(double value, int decimals) {
  return format(value, std::chars_format::fixed, decimals);
}

std::string formatPercent(double share, int decimals) {
  return std::isfinite(share) ? formatFixed(100 * share, decimals) + " %" : "-";
}

std::string formatShort(double value, int digits) {
  return format(value, std::chars_format::general, digits);
}

}  // namespace posture
