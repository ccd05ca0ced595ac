// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/utf8.h>

#include <gtest/gtest.h>

#include <string>

namespace posture {
namespace {

TEST(Utf8, countsTheBytesOfEachCharacter) {
  const std::string text = "a\u00E4\u20AC\U0001F408";
  std::size_t place = 0;
  for (const std::size_t length : {1, 2, 3, 4}) {
    EXPECT_EQ(characterLength(text, place), length);
    for (std::size_t k = 1; k < length; ++k) {
      EXPECT_TRUE(isContinuation(text[place + k]));
      EXPECT_EQ(characterLength(text, place + k), 0);
    }
    place += length;
  }
  EXPECT_EQ(place, text.size());
  EXPECT_TRUE(isUtf8(text));
  EXPECT_TRUE(isUtf8(""));
}

TEST(Utf8, refusesWhatRfc3629Does) {
  for (const std::string wrong : {"\xE4",              // Latin-1
                                  "\xC3",              // cut off
                                  "\xE2\x82",          // the same, of three
                                  "\xC0\xAF",          // a slash in two bytes
                                  "\xE0\x80\xAF",      // in three
                                  "\xF0\x80\x80\xAF",  // in four
                                  "\xED\xA0\x80",      // half of a pair of UTF-16
                                  "\xF4\x90\x80\x80",  // beyond Unicode
                                  "\xFF"}) {
    EXPECT_FALSE(isUtf8(wrong)) << wrong.size();
    EXPECT_FALSE(isUtf8("a" + wrong + "b")) << wrong.size();
  }
}

}  // namespace
}  // namespace posture
