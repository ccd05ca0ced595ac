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
  Faces faces(4, 3);
  faces << 4, 3, 2, 0, 2, 1, 5, 4, 1, 3, 1, 4;
  Faces expected(2, 3);
  expected << 4, 1, 0, 0, 4, 1;
  EXPECT_EQ(weldedFaces(faces, weld(places())), expected);
}

}  // namespace
}  // namespace posture
