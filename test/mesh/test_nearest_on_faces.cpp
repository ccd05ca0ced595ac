// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/nearest_on_faces.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>

namespace posture {
namespace {

using Eigen::Vector3d;

/// A square of two by two quads with corners at whole numbers, the middle one vertex 4.
class NearestOnFaces : public testing::Test {
 protected:
  void lookAtAll(const Vector3d& point, NearestPlace& best) const {
    for (int f = 0; f < mesh_.faces.rows(); ++f)
      lookInFace(mesh_.vertices, mesh_.faces, f, point, best);
  }

  Vector3d placeOf(const NearestPlace& at) const {
    return (at.barycentric.transpose() * mesh_.vertices(mesh_.faces.row(at.face), Eigen::all))
        .transpose();
  }

  const TriangleMesh mesh_ = test::grid(2, 2, 2, 2);
  const VertexFaces faces_at_{mesh_.faces, 9};
};

TEST_F(NearestOnFaces, aroundAVertexIsWhatIsNearestInTheFacesThere) {
  const Vector3d above(0.7, 1.2, 0.5);
  NearestPlace all, around;
  lookAtAll(above, all);
  lookAround(mesh_.vertices, mesh_.faces, faces_at_, 4, above, around);
  EXPECT_EQ(around.face, all.face);
  EXPECT_TRUE(around.place.isApprox(Vector3d(0.7, 1.2, 0)));
  EXPECT_TRUE(placeOf(around).isApprox(around.place));
  EXPECT_DOUBLE_EQ(around.squared, 0.25);
}

TEST_F(NearestOnFaces, looksNoFartherThanTheFacesAtTheVertex) {
  NearestPlace best;
  lookAround(mesh_.vertices, mesh_.faces, faces_at_, 0, {1.7, 1.7, 0}, best);
  EXPECT_LE(best.place.maxCoeff(), 1);
  EXPECT_NE(std::count(faces_at_.begin(0), faces_at_.end(0), best.face), 0);
}

TEST_F(NearestOnFaces, ofEqualsTheFirstIsTaken) {
  const Vector3d above_the_middle(1, 1, 1);
  NearestPlace best;
  lookAround(mesh_.vertices, mesh_.faces, faces_at_, 4, above_the_middle, best);
  EXPECT_EQ(best.face, *faces_at_.begin(4));
  NearestPlace known(mesh_.vertices.row(4), above_the_middle);
  lookAround(mesh_.vertices, mesh_.faces, faces_at_, 4, above_the_middle, known);
  EXPECT_EQ(known.face, -1);
  EXPECT_EQ(known.place, Vector3d(1, 1, 0));
  EXPECT_EQ(known.squared, 1);
}

TEST(LargestCorner, isTheFirstOfEquals) {
  EXPECT_EQ(largestCorner({0.2, 0.5, 0.3}), 1);
  EXPECT_EQ(largestCorner({0, 0.5, 0.5}), 1);
  EXPECT_EQ(largestCorner({0.5, 0, 0.5}), 0);
}

}  // namespace
}  // namespace posture
