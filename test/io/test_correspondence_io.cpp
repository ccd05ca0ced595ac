// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files.h"

namespace posture {
namespace {

using test::bytesOf;
using test::inputErrorOf;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string csv_header = "source,target,face,b0,b1,b2,confidence\n";

Correspondence sample() {
  Correspondence c;
  c.on_target = {{7, 3, {0.1, 0.7, 0.2}}, {}, {4, -1, {0, 0, 0}}};
  c.confidence = Eigen::Vector3d(1.0 / 3, 0.9, 1);
  return c;
}

TEST(CorrespondenceIo, writesExactlyThis) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "correspondence.csv";
  writeCorrespondence(path, sample());
  EXPECT_EQ(bytesOf(path),
            csv_header +
                "0,7,3,0.1,0.7,0.2,0.3333333333333333\n"
                "1,-1,-1,0,0,0,0\n"
                "2,4,-1,0,0,0,1\n");
}

TEST(CorrespondenceIo, comesBack) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "correspondence.csv";
  writeCorrespondence(path, sample());
  const Correspondence read = readCorrespondence(path);
  ASSERT_EQ(read.on_target.size(), 3u);
  EXPECT_EQ(read.on_target[0].vertex, 7);
  EXPECT_EQ(read.on_target[0].face, 3);
  EXPECT_EQ(read.on_target[0].barycentric, Eigen::Vector3d(0.1, 0.7, 0.2));
  EXPECT_EQ(read.on_target[1].vertex, -1);
  EXPECT_EQ(read.confidence, Eigen::Vector3d(1.0 / 3, 0, 1));
}

TEST(CorrespondenceIo, readsWindowsLinesAndNoLastLineEnd) {
  const TemporaryFolder folder;
  const auto path = folder.file("c.csv",
                                "source,target,face,b0,b1,b2,confidence\r\n"
                                "0,1,2,0,0.5,0.5,1\r\n1,-1,-1,0,0,0,0");
  EXPECT_EQ(readCorrespondence(path).on_target.size(), 2u);
}

TEST(CorrespondenceIo, aByteOrderMarkIsSkipped) {
  const TemporaryFolder folder;
  const auto path = folder.file("c.csv", "\xef\xbb\xbf" + csv_header + "0,1,2,0,0.5,0.5,1\n");
  EXPECT_EQ(readCorrespondence(path).on_target.size(), 1u);
  EXPECT_EQ(readVertexPairs(folder.file("p.txt",
                                        "\xef\xbb\xbf"
                                        "0 5\n3 1\n"))
                .size(),
            2u);
}

TEST(CorrespondenceIo, aConfidenceTooFewIsTheCallersMistake) {
  Correspondence c = sample();
  c.confidence.resize(2);
  EXPECT_THROW(writeCorrespondence("unused.csv", c), std::invalid_argument);
}

TEST(CorrespondenceIo, saysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::pair<std::string, std::string> cases[] = {
      {"", "empty"},
      {"0 1\n", "line 1: the first line is not source,target"},
      {csv_header + "0,1,2,0,0.5,0.5\n", "line 2: not 7 fields"},
      {csv_header + "0,1,2,0,0.5,0.5,1,9\n", "line 2: not 7 fields"},
      {csv_header + "1,1,2,0,0.5,0.5,1\n", "line 2: source is 1, expected 0"},
      {csv_header + "0,-2,2,0,0.5,0.5,1\n", "'-2' is not a vertex"},
      {csv_header + "0,99999999999,2,0,0.5,0.5,1\n", "'99999999999' is not a vertex"},
      {csv_header + "0,1,2,0,0.5,nan,1\n", "'nan' is not a number"},
      {csv_header + "0,1,2,0,0.5,0.1,1\n", "do not add up to 1"},
      {csv_header + "0,1,2,0,0.5,0.5,1.5\n", "'1.5' is not a number from 0 to 1"},
      {csv_header + std::string("0,1\0\n", 5), "not 7 fields"}};
  for (const auto& [text, expected] : cases) {
    const auto path = folder.file("c.csv", text);
    const std::string message = inputErrorOf([&, p = path] { readCorrespondence(p); });
    EXPECT_THAT(message, StartsWith(path.string() + ": ")) << text;
    EXPECT_THAT(message, HasSubstr(expected));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
  }
}

TEST(VertexPairs, comeBackAndSkipComments) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "pairs.txt";
  writeVertexPairs(path, {{0, 5}, {3, 1}});
  EXPECT_EQ(bytesOf(path), "0 5\n3 1\n");
  EXPECT_EQ(readVertexPairs(path).size(), 2u);
  const auto pairs = readVertexPairs(folder.file("p.txt", "# head\r\n\r\n 4\t8 # tail\r\n\n2 1"));
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].source, 4);
  EXPECT_EQ(pairs[0].target, 8);
  EXPECT_EQ(pairs[1].target, 1);
}

TEST(VertexPairs, saysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::pair<std::string, std::string> cases[] = {
      {"", "empty"},
      {"# nothing\n", "no vertex pairs"},
      {"0 1\n2\n", "line 2: a vertex number is missing"},
      {"0 1\r\n2\r\n", "line 2: a vertex number is missing"},
      {"0 1 2\n", "line 1: '2' behind a pair"},
      {"0 -1\n", "line 1: vertex number -1 is out of range"},
      {"0 99999999999\n", "out of range"},
      {"0 1.5\n", "'1.5' is not a whole number"}};
  for (const auto& [text, expected] : cases) {
    const auto path = folder.file("p.txt", text);
    const std::string message = inputErrorOf([&, p = path] { readVertexPairs(p); });
    EXPECT_THAT(message, StartsWith(path.string() + ": ")) << text;
    EXPECT_THAT(message, HasSubstr(expected));
  }
  EXPECT_THAT(inputErrorOf([&] { readVertexPairs(folder.path() / "no.txt"); }),
              HasSubstr("no such file"));
}

}  // namespace
}  // namespace posture
