// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/evaluation/pair_list.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files.h"
#include <filesystem>
#include <fstream>

namespace posture {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PairList : public testing::Test {
 protected:
  std::vector<BenchmarkPair> read(const std::string& text) const {
    std::ofstream(folder_ / "pairs.csv", std::ios::binary) << text;
    return readPairList(folder_ / "pairs.csv");
  }

  /// The message of the InputError that reading `text` ends in.
  std::string errorOf(const std::string& text) const {
    return test::inputErrorOf([&] { read(text); });
  }

  const test::TemporaryFolder folder_;
};

TEST(Csv, readsQuotes) {
  EXPECT_THAT(
      parseCsv("a,\"b, c\",d\r\n\n\"say \"\"no\"\"\",,\"two\nlines\""),
      ElementsAre(ElementsAre("a", "b, c", "d"), ElementsAre("say \"no\"", "", "two\nlines")));
  EXPECT_THAT(parseCsv("a,\n"), ElementsAre(ElementsAre("a", "")));
  EXPECT_TRUE(parseCsv("").empty());
  EXPECT_THROW(parseCsv("\"open"), InputError);
  EXPECT_THROW(parseCsv("\"a\"b,c"), InputError);
}

TEST_F(PairList, readsRows) {
  const auto pairs = read(
      "id,family,kind,source,target,truth,mirror_truth,note\n"
      "a,cat,isometric,m/a.obj,m/b.obj,identity,,\"small, clean\"\n"
      "b,cat,scan,/abs/c.ply,m/d.ply,t/b.txt,t/b.mirror.txt,\n");
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].id, "a");
  EXPECT_EQ(pairs[0].source, folder_.path() / "m/a.obj");
  EXPECT_EQ(pairs[0].truth, "identity");
  EXPECT_TRUE(pairs[0].mirror_truth.empty());
  EXPECT_EQ(pairs[0].note, "small, clean");
  EXPECT_EQ(pairs[1].source, "/abs/c.ply");
  EXPECT_EQ(pairs[1].truth, folder_ / "t/b.txt");
  EXPECT_EQ(pairs[1].mirror_truth, folder_ / "t/b.mirror.txt");
}

TEST_F(PairList, columnsInAnyOrderAndFew) {
  const auto pairs = read("target,id,source\nb.obj,x,a.obj\n");
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].source, folder_ / "a.obj");
  EXPECT_TRUE(pairs[0].truth.empty());
}

TEST_F(PairList, skipsAByteOrderMark) {
  EXPECT_EQ(read("\xef\xbb\xbfid,source,target\nx,a.obj,b.obj\n").size(), 1u);
}

TEST_F(PairList, saysWhatIsWrong) {
  const std::string head = "id,source,target\n";
  EXPECT_THAT(errorOf(""), HasSubstr("pairs.csv: the file is empty"));
  EXPECT_THAT(errorOf("\n\n"), HasSubstr("no line but blank ones"));
  EXPECT_THAT(errorOf(head), HasSubstr("lists no pair"));
  EXPECT_THAT(errorOf("id,source\na,b\n"), HasSubstr("no column 'target'"));
  EXPECT_THAT(errorOf(head + "a,b\n"), HasSubstr("record 1 has 2 fields, the header 3"));
  EXPECT_THAT(errorOf(head + "a,b,c\na,b,c\n"), HasSubstr("used twice"));
  EXPECT_THAT(errorOf(head + "../a,b,c\n"), HasSubstr("is not made of letters, digits"));
  EXPECT_THAT(errorOf(head + std::string(201, 'i') + ",b,c\n"),
              HasSubstr("pairs.csv: the id 'iiiiiiiiiiiiiiiiiiiiiiii...' is longer than 200"));
  EXPECT_EQ(read(head + std::string(200, 'i') + ",b,c\n").size(), 1u);
  EXPECT_THAT(errorOf(head + "a,,c\n"), HasSubstr("lacks its source"));
  EXPECT_THAT(errorOf(head + "a,\"b,c\n"), HasSubstr("never closed"));
  EXPECT_THROW(readPairList(folder_ / "none.csv"), InputError);
  EXPECT_THROW(readPairList(folder_.path()), InputError);
}

}  // namespace
}  // namespace posture
