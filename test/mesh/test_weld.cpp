// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/weld.h>

#include <gtest/gtest.h>

#include <vector>

namespace posture {
namespace {

Points places() {
  Points vertices(6, 3);
  vertices << 1, 2, 3, 0, 5, 0, 1, 2, 3, -0.0, 5, -0.0, 1, 2, 3.0000000000000004, 1, 2, 3;
  return vertices;
}

TEST(Weld, eachVertexHasTheFirstAtItsVeryPlace) {
  EXPECT_EQ(weld(places()), (std::vector<int>{0, 1, 0, 1, 4, 0}));
  EXPECT_TRUE(weld(Points(0, 3)).empty());
}

TEST(WeldedFaces, areBetweenFirstVerticesAndNoneHasOneTwice) {
  Faces faces(3, 3);
  faces << 4, 3, 2, 0, 2, 1, 3, 1, 4;
  Faces expected(1, 3);
  expected << 4, 1, 0;
  EXPECT_EQ(weldedFaces(faces, weld(places())), expected);
}

TEST(WeldedFaces, ofSeveralBetweenTheSameCornersTheFirstStays) {
  Faces faces(5, 3);
  faces << 0, 2, 1, 1, 4, 0, 5, 4, 1, 4, 3, 2, 3, 1, 0;
  Faces expected(1, 3);
  expected << 1, 4, 0;
  const WeldedFaces welded = weldFaces(faces, weld(places()));
  EXPECT_EQ(welded.faces, expected);
  EXPECT_EQ(welded.input_face, (std::vector<int>{1}));
  EXPECT_EQ(welded.degenerate, 2);
  EXPECT_EQ(welded.repeated, 2);
}

}  // namespace
}  // namespace posture
