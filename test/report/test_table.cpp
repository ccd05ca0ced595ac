// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/table.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace posture {
namespace {

const TextTable TABLE{
    {"pair", "error", "note"},
    {{"cat", "1.50", "good"}, {"horse, grey", "-", "says \"neigh\""}, {"a|b", "12"}}};

TEST(Table, textAlignsNumbersRightAndWordsLeft) {
  EXPECT_EQ(toText(TABLE),
            "pair         error  note\n"
            "cat           1.50  good\n"
            "horse, grey      -  says \"neigh\"\n"
            "a|b             12\n");
}

TEST(Table, markdownEscapesBars) {
  EXPECT_EQ(toMarkdown(TABLE),
            "| pair        | error | note         |\n"
            "| ----------- | ----: | ------------ |\n"
            "| cat         |  1.50 | good         |\n"
            "| horse, grey |     - | says \"neigh\" |\n"
            "| a\\|b        |    12 |              |\n");
}

TEST(Table, csvQuotesWhatNeedsIt) {
  EXPECT_EQ(toCsv(TABLE),
            "pair,error,note\n"
            "cat,1.50,good\n"
            "\"horse, grey\",-,\"says \"\"neigh\"\"\"\n"
            "a|b,12,\n");
  EXPECT_EQ(toCsv({{"two\nlines"}, {}}), "\"two\nlines\"\n");
}

TEST(Table, lettersAreCountedNotBytes) {
  EXPECT_EQ(toText({{"name", "x"}, {{"B\u00e4r", "1"}, {"Katze", "2"}}}),
            "name   x\nB\u00e4r    1\nKatze  2\n");
}

TEST(Table, rowLongerThanHeaderThrows) {
  const TextTable table{{"a"}, {{"1", "2"}}};
  EXPECT_THROW(toText(table), std::invalid_argument);
  EXPECT_THROW(toMarkdown(table), std::invalid_argument);
  EXPECT_THROW(toCsv(table), std::invalid_argument);
}

TEST(Table, numbers) {
  EXPECT_EQ(formatFixed(1.005, 1), "1.0");
  EXPECT_EQ(formatFixed(-2.25, 2), "-2.25");
  EXPECT_EQ(formatShort(0.00123456), "0.001235");
  EXPECT_EQ(formatShort(1234567.0, 3), "1.23e+06");
  EXPECT_EQ(formatShort(std::numeric_limits<double>::infinity()), "-");
  EXPECT_EQ(formatFixed(std::nan(""), 3), "-");
  EXPECT_EQ(formatPercent(0.1254), "12.5 %");
  EXPECT_EQ(formatPercent(1, 0), "100 %");
  EXPECT_EQ(formatPercent(std::nan("")), "-");
}

}  // namespace
}  // namespace posture
