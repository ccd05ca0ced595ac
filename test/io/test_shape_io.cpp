// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/encode.h"
#include "support/files.h"
#include "support/shapes.h"
#include <cmath>
#include <limits>
#include <string>

namespace posture {
namespace {

using test::inputErrorOf;
using test::raw;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr double NOTHING = std::numeric_limits<double>::quiet_NaN();

PointCloud readCloud(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  const Shape shape = readShape(folder.file(name, bytes));
  EXPECT_EQ(shape.faces.rows(), 0);
  return shape.cloud;
}

std::string messageOf(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  const auto path = folder.file(name, bytes);
  const std::string message = inputErrorOf([&] { readShape(path); });
  EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

Points rows(std::initializer_list<Eigen::RowVector3d> all) {
  Points points(static_cast<Eigen::Index>(all.size()), 3);
  Eigen::Index i = 0;
  for (const Eigen::RowVector3d& row : all) points.row(i++) = row;
  return points;
}

/// The same numbers, NaN where the other is NaN.
void expectSame(const Points& actual, const Points& expected) {
  ASSERT_EQ(actual.rows(), expected.rows());
  for (Eigen::Index i = 0; i < actual.rows(); ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_TRUE(actual(i, c) == expected(i, c) ||
                  (std::isnan(actual(i, c)) && std::isnan(expected(i, c))))
          << i << ' ' << c << ": " << actual(i, c) << " for " << expected(i, c);
}

std::string pcd(const std::string& fields,
                const std::string& sizes,
                const std::string& types,
                const std::string& counts,
                const std::string& width,
                const std::string& height,
                const std::string& data,
                const std::string& viewpoint = "0 0 0 1 0 0 0") {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " +
         sizes + "\nTYPE " + types + "\nCOUNT " + counts + "\nWIDTH " + width + "\nHEIGHT " +
         height + "\nVIEWPOINT " + viewpoint + "\nPOINTS " +
         std::to_string(std::stoi(width) * std::stoi(height)) + "\nDATA " + data;
}

std::string plainPcd(const std::string& points, const std::string& data) {
  return pcd("x y z", "4 4 4", "F F F", "1 1 1", points, "1", data);
}

/// LZF that compresses nothing: runs of at most 32 bytes, each behind its length less one.
std::string storedLzf(const std::string& bytes) {
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 32) {
    const std::string run = bytes.substr(i, 32);
    out += static_cast<char>(run.size() - 1) + run;
  }
  return out;
}

std::string compressed(const std::string& lzf, std::size_t full) {
  return "binary_compressed\n" + raw(static_cast<std::uint32_t>(lzf.size())) +
         raw(static_cast<std::uint32_t>(full)) + lzf;
}

TEST(Ply, sharesOfColourAreKnownThoughTheFirstPointHasNone) {
  const PointCloud cloud = readCloud("a.ply",
                                     "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                                     "property float y\nproperty float z\nproperty float red\n"
                                     "property float green\nproperty float blue\nend_header\n"
                                     "nan nan nan nan nan nan\n1 2 3 1 0.2 0\n");
  ASSERT_EQ(cloud.colors.rows(), 2);
  EXPECT_EQ(cloud.colors.row(1), (Eigen::Matrix<std::uint8_t, 1, 3>(255, 51, 0)));
}

TEST(Pcd, asciiWithNormalsColoursAndUnseenPoints) {
  const PointCloud cloud = readCloud(
      "a.pcd",
      pcd("x y z normal_x normal_y normal_z rgb",
          "4 4 4 4 4 4 4",
          "F F F F F F U",
          "1 1 1 1 1 1 1",
          "3",
          "1",
          "ascii\r\n1 2.5 -3e-1 0 0 1 16909060\r\nnan nan nan nan nan nan 0\n4 inf 6 0 1 0 255\n"));
  expectSame(cloud.points,
             rows({{1, 2.5, -0.3}, {NOTHING, NOTHING, NOTHING}, {NOTHING, NOTHING, NOTHING}}));
  expectSame(cloud.normals, rows({{0, 0, 1}, {0, 0, 0}, {0, 1, 0}}));
  ASSERT_EQ(cloud.colors.rows(), 3);
  EXPECT_EQ(cloud.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(2, 3, 4)));
  EXPECT_EQ(cloud.colors.row(2), (Eigen::Matrix<std::uint8_t, 1, 3>(0, 0, 255)));
  EXPECT_EQ(cloud.width, 0);
  EXPECT_FALSE(cloud.sensor);
}

TEST(Pcd, binaryOfEveryTypeInAnyOrderPastWideFields) {
  std::string data;
  for (int i = 0; i < 2; ++i)
    data += raw<std::int8_t>(-5) + raw<float>(7) + raw<float>(8) + raw<float>(9) +
            raw<double>(0.1 + i) + raw<std::uint8_t>(200) + raw<std::int16_t>(-300) +
            raw<std::uint16_t>(60000) + raw<std::int64_t>(-1) + raw<std::uint64_t>(1) +
            raw<std::int32_t>(70000) + raw<std::uint32_t>(4000000000u);
  const std::string header = pcd("label fpfh z r y g a b normal_y x",
                                 "1 4 8 1 2 2 8 8 4 4",
                                 "I F F U I U I U I U",
                                 "1 3 1 1 1 1 1 1 1 1",
                                 "2",
                                 "1",
                                 "binary\n");
  const PointCloud cloud = readCloud("a.pcd", header + data);
  expectSame(cloud.points, rows({{4e9, -300, 0.1}, {4e9, -300, 1.1}}));
  ASSERT_EQ(cloud.colors.rows(), 2);
  EXPECT_EQ(cloud.colors.row(1), (Eigen::Matrix<std::uint8_t, 1, 3>(200, 255, 1)));
  EXPECT_EQ(cloud.normals.rows(), 0);
}

TEST(Pcd, asciiSkipsWideFields) {
  const PointCloud cloud =
      readCloud("a.pcd",
                pcd("x wide y none z", "4 4 4 4 4", "F U F F F", "1 3 1 0 1", "2", "1", "ascii\n") +
                    "1 9 words 9 2 3\n4 9 9 9 5 6\n");
  expectSame(cloud.points, rows({{1, 2, 3}, {4, 5, 6}}));
}

TEST(Pcd, floatsHoldColoursWhoseBitsAreNoNumber) {
  // 0xffa0b0c0 and 0xff90b0c0 are NaN, the latter a signalling one.
  const auto point = [](std::uint32_t color) {
    return raw<float>(1) + raw<float>(2) + raw<float>(3) + raw(color);
  };
  const std::string header = pcd("x y z rgba", "4 4 4 4", "F F F F", "1 1 1 1", "2", "1", "");
  const PointCloud cloud =
      readCloud("a.pcd", header + "binary\n" + point(0xffe0b0c0u) + point(0xff90b0c0u));
  EXPECT_EQ(cloud.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(0xe0, 0xb0, 0xc0)));
  EXPECT_EQ(cloud.colors.row(1), (Eigen::Matrix<std::uint8_t, 1, 3>(0x90, 0xb0, 0xc0)));
  // The number 1 has the bits 0x3f800000.
  EXPECT_EQ(readCloud("a.pcd", header + "ascii\n1 2 3 1.0\n1 2 3 1.0\n").colors.row(0),
            (Eigen::Matrix<std::uint8_t, 1, 3>(0x80, 0, 0)));
}

TEST(Pcd, compressedHoldsFieldAfterField) {
  std::string data = raw<float>(1) + raw<float>(2);
  for (int i = 0; i < 4; ++i) data += raw<double>(9);
  data += raw<float>(3) + raw<float>(4) + raw<std::uint16_t>(5) + raw<std::uint16_t>(6);
  const std::string header = pcd("x skip y z", "4 8 4 2", "F F F U", "1 2 1 1", "2", "1", "");
  expectSame(readCloud("a.pcd", header + compressed(storedLzf(data), data.size())).points,
             rows({{1, 3, 5}, {2, 4, 6}}));
}

TEST(Pcd, compressedMayReferBack) {
  // A literal byte 0, then 35 more of it: length 9 + 26, one byte back.
  const std::string lzf =
      std::string("\0\0", 2) + "\xe0" + static_cast<char>(35 - 9) + std::string(1, '\0');
  expectSame(readCloud("a.pcd",
                       pcd("x y z", "4 4 4", "F F F", "1 1 1", "3", "1", "") + compressed(lzf, 36))
                 .points,
             rows({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
}

TEST(Pcd, gridsHaveAWidthAndASensor) {
  const std::string six = "ascii\n0 0 0\n1 0 0\nnan nan nan\n3 0 0\n4 0 0\n5 0 0\n";
  const PointCloud grid =
      readCloud("a.pcd", pcd("x y z", "4 4 4", "F F F", "1 1 1", "3", "2", six));
  EXPECT_EQ(grid.width, 3);
  EXPECT_EQ(grid.sensor, Eigen::Vector3d(0, 0, 0));
  const PointCloud seen = readCloud(
      "a.pcd", pcd("x y z", "4 4 4", "F F F", "1 1 1", "6", "1", six, "1 2.5 -3 0.7 0 0.7 0"));
  EXPECT_EQ(seen.width, 0);
  EXPECT_EQ(seen.sensor, Eigen::Vector3d(1, 2.5, -3));
  const PointCloud column =
      readCloud("a.pcd", pcd("x y z", "4 4 4", "F F F", "1 1 1", "1", "6", six));
  EXPECT_EQ(column.width, 0);
}

TEST(Pcd, olderHeadersLeaveThingsOut) {
  expectSame(readCloud("a.pcd",
                       "# .PCD v.5 - Point Cloud Data file format\nVERSION .5\nFIELDS x y z\n"
                       "SIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
                       "1 2 3\n# between\n\n4 5 6")
                 .points,
             rows({{1, 2, 3}, {4, 5, 6}}));
  expectSame(readCloud("a.dat", "# .PCD v.4\nCOLUMNS z y x\nPOINTS 1\nDATA ascii\n3 2 1\n").points,
             rows({{1, 2, 3}}));
  EXPECT_EQ(readCloud("a.pcd", "\xef\xbb\xbf# .PCD\nFIELDS x y z\nWIDTH 1\nDATA ascii\n3 2 1\n")
                .points.rows(),
            1);
}

TEST(Pcd, whatIsNoPointMayStandBehindTheLast) {
  std::string data;
  for (int i = 1; i <= 6; ++i) data += raw(static_cast<float>(i));
  const std::string header = pcd("x y z", "4 4 4", "F F F", "1 1 1", "2", "1", "");
  // PCL before 1.9 made the file a page longer than the points.
  for (const std::string& more :
       {std::string("\r\n"), std::string(11, 'x'), std::string(4096, '\0')})
    for (const std::string& bytes : {"binary\n" + data, compressed(storedLzf(data), data.size())}) {
      const Points points = readCloud("a.pcd", header + bytes + more).points;
      EXPECT_EQ(points.rows(), 2);
    }
}

TEST(Pcd, isKnownBehindAByteOrderMark) {
  EXPECT_EQ(readCloud("a.dat", "\xef\xbb\xbf# .PCD\nFIELDS x y z\nWIDTH 1\nDATA ascii\n3 2 1\n")
                .points.rows(),
            1);
}

TEST(Pcd, badFilesAreRefusedInOneLine) {
  const std::string point = raw<float>(1) + raw<float>(2) + raw<float>(3);
  const std::string header = pcd("x y z", "4 4 4", "F F F", "1 1 1", "2", "1", "");
  const auto expect = [](const std::string& bytes, const char* message) {
    EXPECT_THAT(messageOf("a.pcd", bytes), HasSubstr(message));
  };
  expect("rubbish 1 2\n", "line 1: 'rubbish' is not a PCD header line");
  expect("# .PCD\nFIELDS x y z\n", "the header has no DATA line");
  expect(header + "ascii\n1 2 3\n", "too many for the size of the file");
  expect(header + "ascii\n1 2 3          ", "truncated: 1 of 2 points");
  expect(header + "ascii\n1 2 3\n4 5\n       ", "too few numbers");
  expect(header + "ascii\n1 2 3\n4 5 6 7\n", "line 13: a point with too many numbers");
  expect(header + "ascii\n1 2 3\n4 5 6\n7 8 9\n", "more than the 2 points of its header");
  expect(header + "ascii\n1 2 3\n4 five 6\n", "line 13: y: 'five' is not a number");
  expect(header + "ascii\n1 2 3\n4,0 5 6\n", "'4,0' is not a number");
  expect(header + "binary\n" + point, "truncated: its header says 2 points");
  expect(header + "binary\n" + point + point + point,
         "more than the 2 points of its header: 12 bytes behind them");
  expect(header + compressed(storedLzf(point + point), 24) + point, "more than the 2 points");
  expect(header + "gzip\n", "DATA 'gzip' where");
  expect(header + "binary_compressed\n1234", "sizes of the compressed points are missing");
  expect(header + compressed(point, 24).substr(0, 30), "truncated: ");
  expect(header + compressed(storedLzf(point), 12), "are not the 12 bytes that were compressed");
  expect(header + compressed(storedLzf(point), 24), "the compressed points are damaged");
  expect(header + compressed(storedLzf(point + point) + "xx", 24), "are damaged");
  expect(plainPcd("300000000", compressed("12", 3600000000u)), "are damaged");
  expect(plainPcd("0", "ascii\n"), "there are no points in it");
  expect(plainPcd("1", "ascii\nnan nan inf\n"), "none of its 1 points has finite coordinates");
  expect(plainPcd("-1", "ascii\n"), "WIDTH is out of range: -1");
  expect(pcd("x y", "4 4", "F F", "1 1", "1", "1", "ascii\n1 2\n"), "have no x, y and z");
  expect(pcd("x y z", "4 4", "F F F", "1 1 1", "1", "1", "ascii\n1 2 3\n"), "SIZE has 2 entries");
  expect(pcd("x y z", "4 4 3", "F F F", "1 1 1", "1", "1", "ascii\n1 2 3\n"),
         "unknown TYPE 'F' of SIZE '3'");
  expect(pcd("x y z", "4 4 4", "F F F", "1 1 99999999999", "1", "1", "ascii\n1 2 3\n"),
         "COUNT 99999999999 is out of range");
  expect("FIELDS x y z\nWIDTH 2147483646\nHEIGHT 2147483646\nDATA ascii\n1 2 3\n", "out of range");
  expect("FIELDS x y z\nWIDTH 2000000000\nHEIGHT 1\nDATA binary\n123", "too many for the size");
  expect("FIELDS x y z\nWIDTH 3\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3\n", "is not POINTS 2");
  expect("FIELDS x y z\nVIEWPOINT 1 2 nan 1 0 0 0\nDATA ascii\n1 2 3\n", "VIEWPOINT is not finite");
  expect("FIELDS x y z\nVIEWPOINT 1 2\nDATA ascii\n1 2 3\n", "VIEWPOINT is missing");
}

const Points TWO = rows({{1, 2.5, -3}, {4e2, 5, 6}});

TEST(Table, anySeparatorAndLineEnd) {
  for (const char* text : {"1 2.5 -3\n4e2 5 6\n",
                           "1\t2.5\t-3\r\n4e2\t5\t6\r\n",
                           "1 2.5 -3\r4e2 5 6\r",
                           "2\r# a comment\r1 2.5 -3 // first\r\r4e2 5 6",
                           "1 2.5 -3\r4e2 5 6\n",
                           "1,2.5,-3\n4e2,5,6",
                           "1, 2.5, -3\n4e2 ,5 , 6,\n",
                           "1;2.5;-3\n4e2; 5; 6\n",
                           "  1  2.5  -3  \n\n  4e2 5\t6\n\n",
                           "\xef\xbb\xbf"
                           "1 2.5 -3\n4e2 5 6\n",
                           "# 9 points of x, y and z\n1 2.5 -3 # first\n// second\n4e2 5 6\n",
                           "2\r\n1 2.5 -3\n4e2 5 6\n",
                           "+1 2.5 -3.\n400 5 6e0\n"})
    for (const char* name : {"a.xyz", "a.TXT", "a.csv", "a.asc", "a.pts"}) {
      SCOPED_TRACE(text);
      const PointCloud cloud = readCloud(name, text);
      expectSame(cloud.points, TWO);
      EXPECT_EQ(cloud.normals.rows() + cloud.colors.rows() + cloud.width, 0);
    }
}

TEST(Table, unseenPointsAreKept) {
  for (const char* unseen : {"nan nan nan", "nan,2,NaN", ",,", "1,,2", "1,2,", "-inf 0 0"})
    expectSame(readCloud("a.csv", std::string("1 2 3\n") + unseen).points,
               rows({{1, 2, 3}, {NOTHING, NOTHING, NOTHING}}));
}

TEST(Table, namesSayWhatTheColumnsAre) {
  for (const char* head : {"b,z,label,x,y,nx,g,ny,nz,r",
                           "\"B\",\"Z\",\"Label\",\"X\",\"Y\",\"Nx\",\"G\",\"Ny\",\"Nz\",\"R\"",
                           "//B Z scalar X Y Nx G Ny Nz R",
                           "# b z label x [m] y (m) normal_x green normal_y nz red"}) {
    SCOPED_TRACE(head);
    const PointCloud cloud = readCloud("a.txt", std::string(head) + "\n30,3,7,1,2,0,20,0,5,10\n");
    expectSame(cloud.points, rows({{1, 2, 3}}));
    expectSame(cloud.normals, rows({{0, 0, 5}}));
    ASSERT_EQ(cloud.colors.rows(), 1);
    EXPECT_EQ(cloud.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(10, 20, 30)));
  }
  expectSame(readCloud("a.csv", "x,y,what,z\n1,2.5,hat,-3\n4e2,5,,6\n").points, TWO);
  for (const char* head : {"# Points: x y z", "// Format: X Y Z", "# Columns: x y z intensity"})
    expectSame(readCloud("a.xyz", std::string(head) + "\n1 2.5 -3 7\n4e2 5 6 8\n").points, TWO);
}

TEST(Table, textsMayHaveBlanksBetweenCommas) {
  for (const char* head : {"x,y,seen on,z", "x; y; seen on; z", "X [m], Y [m], what, Z [m]"})
    for (const char* rows : {"1,2.5,the left hand,-3\n4e2,5,a foot,6\n",
                             "1;2.5;hand;-3\n4e2 ; 5 ; the other hand ; 6\n"}) {
      SCOPED_TRACE(head);
      expectSame(readCloud("a.csv", std::string(head) + "\n" + rows).points, TWO);
    }
  for (const char* text : {"# x,y,seen on,z\n1,2.5,the hat,-3\n4e2,5,hat,6\n",
                           "x,y,what,z,note\n1,2.5,foot 7,-3,\n4e2,5,,6,on the floor\n"})
    expectSame(readCloud("a.csv", text).points, TWO);
}

TEST(Table, numbersSayWhatTheColumnsAre) {
  const auto expect = [](const std::string& text, bool normals, bool colors) {
    SCOPED_TRACE(text);
    const PointCloud cloud = readCloud("a.xyz", text);
    EXPECT_EQ(cloud.points.rows(), 2);
    EXPECT_EQ(cloud.normals.rows(), normals ? 2 : 0);
    EXPECT_EQ(cloud.colors.rows(), colors ? 2 : 0);
    if (normals) {
      EXPECT_EQ(Eigen::RowVector3d(cloud.normals.row(1)), Eigen::RowVector3d(0, 0.6, -0.8));
    }
    if (colors) {
      EXPECT_EQ(cloud.colors.row(1), (Eigen::Matrix<std::uint8_t, 1, 3>(255, 0, 51)));
    }
  };
  expect("1 2 3 500\n1 2 3 -4\n", false, false);
  expect("1 2 3 1 0 0\n1 2 3 0 0.6 -0.8\n", true, false);
  expect("1 2 3 nan nan nan\n1 2 3 0 0.6 -0.8\n", true, false);
  expect("1 2 3 1 0 0\n1 2 3 255 0 51\n", false, true);
  expect("1 2 3 0.5 0.5 0.5\n1 2 3 1 0 0.2\n", false, true);
  expect("1 2 3 7 8.5 -9\n1 2 3 1 0 0\n", false, false);
  expect("1 2 3 -999 9 9 9\n1 2 3 20.5 255 0 51\n", false, true);
  expect("1 2 3 1 0 0 0.1\n1 2 3 0 0.6 -0.8 0.2\n", true, false);
  expect("1 2 3 255 0 0 1 0 0\n1 2 3 255 0 51 0 0.6 -0.8\n", true, true);
  expect("1 2 3 1 0 0 255 0 0\n1 2 3 0 0.6 -0.8 255 0 51\n", true, true);
  expect("1 2 3 4 5\n6 7 8 9 10\n", false, false);
}

TEST(Table, anEndingSaysWhatTheNumbersLeaveOpen) {
  const std::string pure = "1 2 3 0 0 1\n4 5 6 0 0 1\n";
  EXPECT_EQ(readCloud("a.xyz", pure).normals.rows(), 2);
  const PointCloud colored = readCloud("a.XYZRGB", pure);
  EXPECT_EQ(colored.normals.rows(), 0);
  EXPECT_EQ(colored.colors.rows(), 2);
  const PointCloud directed = readCloud("a.xyzn", "1 2 3 0 0 2\n4 5 6 0 3 0\n");
  EXPECT_EQ(directed.colors.rows(), 0);
  EXPECT_EQ(Eigen::RowVector3d(directed.normals.row(1)), Eigen::RowVector3d(0, 3, 0));
}

TEST(Table, quotesHoldWordsTogether) {
  for (const char* text : {"\"x\",\"y\",\"z\"\n\"1\",\"2.5\",\"-3\"\n\"4e2\",\"5\",\"6\"\n",
                           "x,y,what,z\n1,2.5,\"hat, #1\",-3\n4e2,5,\"a \"\"b\"\";\",6\n",
                           "x y what z\n1 2.5 \"left // foot\" -3\n4e2 5 7\" 6\n"}) {
    SCOPED_TRACE(text);
    expectSame(readCloud("a.csv", text).points, TWO);
  }
}

TEST(Table, countsAreChecked) {
  expectSame(readCloud("a.pts", "1\n1 2.5 -3\n1\n4e2 5 6\n").points, TWO);
  EXPECT_THAT(messageOf("a.pts", "3\n1 2 3\n4 5 6\n"), HasSubstr("it says 3 points and has 2"));
  EXPECT_THAT(messageOf("a.pts", "1\n1 2 3\n4 5 6\n"), HasSubstr("it says 1 points and has 2"));
  EXPECT_THAT(messageOf("a.pts", "99999999999999\n1 2 3\n"), HasSubstr("fewer than three numbers"));
}

TEST(Table, badFilesAreRefusedInOneLine) {
  const auto expect = [](const std::string& bytes, const char* message) {
    EXPECT_THAT(messageOf("a.csv", bytes), HasSubstr(message));
  };
  for (const char* text :
       {"1,5 2,5 3,5\n", "1,5;2,5;3,5\n", "1 2 3\n1,5 2 3\n", "1;2;3\n1,5;2;3\n"})
    expect(text, "decimal commas cannot be read");
  expect("1 2 3\n4 5\n", "line 2: 2 columns where 3 are expected");
  expect("1 2 3\n4 5 6 7\n", "line 2: 4 columns where 3 are expected");
  expect("1 2 3\n4 x 6\n", "line 2: 'x' is not a number");
  expect("1 2 3\r\n\r\n4 x 6\r\n", "line 3: 'x' is not a number");
  expect("1 2 3\r\r4 x 6\r", "line 3: 'x' is not a number");
  expect("1 2 3\n4 0x5 6\n", "'0x5' is not a number");
  expect("1 2\n", "line 1: fewer than three numbers");
  expect("hello\n", "line 1: 'hello' is not a number");
  expect("a,b,c\n1,2,3\n", "line 1: 'a' is not a number");
  expect("x,y,z\n1,2\n", "line 2: 2 columns where 3 are expected");
  expect("x,y,z\n1 2 3 4\n", "line 2: 4 columns where 3 are expected");
  expect("x,y,what,z\n1,2,the hat,a 4\n", "line 2: 'a 4' is not a number");
  expect("x;y;z\n1,5;2,5;3,5\n", "decimal commas cannot be read");
  expect("\"1,5\";\"2,5\";\"3,5\"\n", "decimal commas cannot be read");
  expect("x y z r g b\n1,5 2,5 3,5\n", "decimal commas cannot be read");
  expect("x y z i\n1,5 2,5 3,5 7\n", "decimal commas cannot be read");
  expect("1 2 3\n1 2,5 3,5\n", "decimal commas cannot be read");
  expect("x,y,intensity\n1,2,3\n", "line 1: columns x and y are named, and none z");
  expect("# x y nx ny nz\n1 2 0 0 1\n", "line 2: columns x and y are named, and none z");
  expect("# nothing\n\n", "there are no points in it");
  expect("nan nan nan\n", "none of its 1 points has finite coordinates");
}

TEST(Shape, meshesAreReadAsReadMeshDoes) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : test::encodeEveryWay(test::grid(3, 2, 1, 2))) {
    SCOPED_TRACE(name);
    const auto path = folder.file(name, bytes);
    const MeshFile mesh = readMesh(path);
    const Shape shape = readShape(path);
    EXPECT_EQ(shape.cloud.points, mesh.mesh.vertices);
    EXPECT_EQ(shape.faces, mesh.mesh.faces);
  }
  const auto renamed = folder.file("off.txt", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(readShape(renamed).faces.rows(), 1);
}

TEST(Shape, cloudsOfMeshFormatsMayHaveUnseenPoints) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n";
  const std::string three = "end_header\n1 2 3 0 0 1\nnan 0 0 nan nan nan\n4 5 6 0 1 0\n";
  const PointCloud cloud = readCloud("a.ply", ply + three);
  expectSame(cloud.points, rows({{1, 2, 3}, {NOTHING, NOTHING, NOTHING}, {4, 5, 6}}));
  expectSame(cloud.normals, rows({{0, 0, 1}, {0, 0, 0}, {0, 1, 0}}));
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  EXPECT_THAT(messageOf("a.ply", ply + face + three + "3 0 1 2\n"),
              HasSubstr("line 14: vertex 1 has a coordinate that is not finite"));
  expectSame(readCloud("a.obj", "v 1 2 3\nv nan nan nan\n").points,
             rows({{1, 2, 3}, {NOTHING, NOTHING, NOTHING}}));
  expectSame(readCloud("a.off", "OFF\n2 0 0\n1 2 3\n0 inf 0\n").points,
             rows({{1, 2, 3}, {NOTHING, NOTHING, NOTHING}}));
  EXPECT_THAT(messageOf("a.obj", "v 1 2 3\nv nan nan nan\nv 1 1 1\nf 1 3 2\n"),
              HasSubstr("line 2: vertex 2 has a coordinate that is not finite"));
  EXPECT_THAT(messageOf("a.las", "LASF"), HasSubstr("unknown format"));
}

PointCloud randomCloud(int count, bool normals, bool colors) {
  PointCloud cloud;
  cloud.points = test::randomPoints(count, 1).cast<float>().cast<double>();
  cloud.points.row(1).setConstant(NOTHING);
  if (normals) {
    cloud.normals = test::randomPoints(count, 2).rowwise().normalized();
    cloud.normals = cloud.normals.cast<float>().cast<double>().eval();
    cloud.normals.row(1).setZero();
  }
  if (colors) {
    cloud.colors.resize(count, 3);
    for (int i = 0; i < count; ++i)
      for (int c = 0; c < 3; ++c) cloud.colors(i, c) = static_cast<std::uint8_t>(91 * i + 40 * c);
  }
  return cloud;
}

TEST(WritePointCloud, comesBackTheSame) {
  const TemporaryFolder folder;
  for (const bool normals : {false, true})
    for (const bool colors : {false, true})
      for (const char* name : {"a.pcd", "a.ply", "a.xyz"}) {
        SCOPED_TRACE(name);
        const PointCloud cloud = randomCloud(12, normals, colors);
        writePointCloud(folder / name, cloud);
        const Shape back = readShape(folder / name);
        expectSame(back.cloud.points, cloud.points);
        expectSame(back.cloud.normals, cloud.normals);
        EXPECT_EQ(back.cloud.colors, cloud.colors);
        EXPECT_EQ(back.cloud.width, 0);
        EXPECT_EQ(back.faces.rows(), 0);
      }
}

TEST(WritePointCloud, plyIsDoubleWhereFloatsWouldMovePoints) {
  const TemporaryFolder folder;
  PointCloud cloud = randomCloud(12, true, false);
  for (const double off : {0.1, 5e5}) {
    cloud.points += Points::Constant(12, 3, off);
    writePointCloud(folder / "a.ply", cloud);
    EXPECT_THAT(test::bytesOf(folder / "a.ply"),
                HasSubstr(off < 1 ? "\nproperty float z\nproperty float nx"
                                  : "\nproperty double z\nproperty float nx"));
    const Points back = readShape(folder / "a.ply").cloud.points;
    EXPECT_LT((back - cloud.points).cwiseAbs().maxCoeff(), off < 1 ? 1e-5 : 1e-12);
  }
}

TEST(WritePointCloud, pcdIsDoubleWhereFloatsWouldMovePoints) {
  const TemporaryFolder folder;
  const auto sizes = [&](const PointCloud& cloud) {
    writePointCloud(folder / "a.pcd", cloud);
    const std::string bytes = test::bytesOf(folder / "a.pcd");
    const std::size_t begin = bytes.find("SIZE ");
    return bytes.substr(begin, bytes.find('\n', begin) - begin);
  };
  PointCloud cloud = randomCloud(12, true, true);
  cloud.points += Points::Constant(12, 3, 0.1);
  EXPECT_EQ(sizes(cloud), "SIZE 4 4 4 4 4 4 4");
  cloud.points.col(1).array() += 5e5;
  EXPECT_EQ(sizes(cloud), "SIZE 8 8 8 4 4 4 4");
  const PointCloud back = readShape(folder / "a.pcd").cloud;
  expectSame(back.points, cloud.points);
  expectSame(back.normals, cloud.normals);
  EXPECT_EQ(back.colors, cloud.colors);
  for (const double scale : {1e-300, 1e300}) {
    cloud.points = randomCloud(12, false, false).points * scale;
    EXPECT_EQ(sizes(cloud), "SIZE 8 8 8 4 4 4 4");
  }
  cloud.points.setConstant(NOTHING);
  EXPECT_EQ(sizes(cloud), "SIZE 4 4 4 4 4 4 4");
}

TEST(WritePointCloud, pcdKeepsGridAndSensor) {
  const TemporaryFolder folder;
  PointCloud cloud = randomCloud(12, false, false);
  cloud.width = 4;
  cloud.sensor = Eigen::Vector3d(0.1, -2, 1e7);
  writePointCloud(folder / "a.pcd", cloud);
  const PointCloud back = readShape(folder / "a.pcd").cloud;
  EXPECT_EQ(back.width, 4);
  EXPECT_EQ(back.sensor, cloud.sensor);
  const std::string bytes = test::bytesOf(folder / "a.pcd");
  EXPECT_THAT(bytes, HasSubstr("\nWIDTH 4\nHEIGHT 3\nVIEWPOINT 0.1 -2 1e+07 1 0 0 0\nPOINTS 12\n"));
  // As the format's description has it: nothing behind the points.
  EXPECT_EQ(bytes.size(), bytes.find("DATA binary\n") + 12 + std::size_t{12} * 12);
}

TEST(WritePointCloud, refusesWhatDoesNotGoTogether) {
  const TemporaryFolder folder;
  PointCloud cloud = randomCloud(12, true, true);
  EXPECT_THROW(writePointCloud(folder / "a.obj", cloud), std::invalid_argument);
  EXPECT_THROW(writePointCloud(folder / "a.pcd", PointCloud{}), std::invalid_argument);
  cloud.width = 5;
  EXPECT_THROW(writePointCloud(folder / "a.pcd", cloud), std::invalid_argument);
  cloud.width = 0;
  cloud.normals.conservativeResize(3, 3);
  EXPECT_THROW(writePointCloud(folder / "a.pcd", cloud), std::invalid_argument);
  EXPECT_TRUE(folder.names().empty());
  EXPECT_THROW(writePointCloud(folder.path() / "none" / "a.pcd", randomCloud(3, false, false)),
               InputError);
}

}  // namespace
}  // namespace posture
