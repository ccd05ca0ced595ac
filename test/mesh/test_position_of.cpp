// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/corners.h>
#include <posture/mesh/position_of.h>

#include <gtest/gtest.h>

#include <vector>

namespace posture {
namespace {

TEST(PlaceOfVertex, isAtOneCornerOfItsFace) {
  Faces faces(2, 3);
  faces << 1, 1, 2, 0, 2, 3;
  const std::vector<int> face_of = faceOfEachVertex(faces, 5);
  const SurfacePoint twice = placeOfVertex(faces, face_of, 1);  // its face names it twice
  EXPECT_EQ(twice.vertex, 1);
  EXPECT_EQ(twice.face, 0);
  EXPECT_EQ(twice.barycentric, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(placeOfVertex(faces, face_of, 3).barycentric, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(placeOfVertex(faces, face_of, 4).face, -1);
}

}  // namespace
}  // namespace posture
