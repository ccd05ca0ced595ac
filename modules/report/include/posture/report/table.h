// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace posture {

/// Rows of texts under a header. Rows may be shorter than the header, not longer.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// The writers set columns of numbers (and of "-" for none) right, others left, and end every line
/// with a line feed. \throws std::invalid_argument  a row longer than the header.
std::string toText(const TextTable& table);      ///< columns aligned by blanks
std::string toMarkdown(const TextTable& table);  ///< readable as it stands, too
std::string toCsv(const TextTable& table);       ///< RFC 4180, fields quoted where need be

/// With so many decimals, whatever the locale; "-" for infinity and NaN.
std::string formatFixed(double value, int decimals);

/// A share of 1 in per cent, "12.5 %"; "-" as above.
std::string formatPercent(double share, int decimals = 1);

/// With so many significant digits, 0.00123 or, where it is far from 1, 1.23e-06 (as %g of
/// printf()); "-" as above.
std::string formatShort(double value, int digits = 4);

}  // namespace posture
