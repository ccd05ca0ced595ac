// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/apply_deformation.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/normals.h>

#include <gtest/gtest.h>

#include "support/cpu_seconds.h"
#include "support/motions.h"
#include "support/shapes.h"
#include <cmath>
#include <limits>

namespace posture {
namespace {

using test::moved;
using test::similarity;

double gap(const Points& x, const Points& y) { return (x - y).rowwise().norm().maxCoeff(); }

TEST(ApplyDeformation, isExactAtTheVertices) {
  const TriangleMesh mesh = test::grid(20, 10, 2, 1);
  const Points bent = test::bentStrip(20, 10, 2, 1, 2).vertices;
  EXPECT_EQ(applyDeformation(mesh, bent, mesh.vertices), bent);
}

TEST(ApplyDeformation, isExactAtVerticesTooNearForSinglePrecision) {
  TriangleMesh mesh = test::grid(20, 10, 2, 1);
  const int v = mesh.faces(200, 0), w = mesh.faces(200, 1);
  mesh.vertices.row(w) = mesh.vertices.row(v) + Eigen::RowVector3d(1e-10, 0, 0);
  Points bent = mesh.vertices;
  bent.col(2) += 0.1 * mesh.vertices.col(0);
  EXPECT_EQ(applyDeformation(mesh, bent, mesh.vertices), bent);
}

TEST(ApplyDeformation, takesEverythingAlongWithASimilarity) {
  const TriangleMesh mesh = test::sphere(2);
  const Points points = 3 * test::randomPoints(200, 4);  // inside and out, near and far
  const Points carried = applyDeformation(mesh, moved(mesh.vertices, similarity()), points);
  EXPECT_LT(gap(carried, moved(points, similarity())), 1e-6);
}

TEST(ApplyDeformation, takesADenserSurfaceAlongABend) {
  const double angle = 1.5;
  const TriangleMesh coarse = test::grid(20, 10, 2, 1), dense = test::grid(83, 41, 2, 1);
  const Points carried =
      applyDeformation(coarse, test::bentStrip(20, 10, 2, 1, angle).vertices, dense.vertices);
  // The sagitta of an edge of length 0.1 on the arc of radius 2 / 1.5 is 0.001.
  EXPECT_LT(gap(carried, test::bentStrip(83, 41, 2, 1, angle).vertices), 0.005);
}

TEST(ApplyDeformation, hasNoJumps) {
  const TriangleMesh mesh = test::grid(20, 10, 2, 1);
  const Points bent = test::bentStrip(20, 10, 2, 1, 2).vertices;
  constexpr int STEPS = 4000;
  Points way(STEPS, 3);
  for (int i = 0; i < STEPS; ++i) {
    const double t = static_cast<double>(i) / STEPS;
    way.row(i) << 0.1 + 1.8 * t, 0.2 + 0.6 * t, 0.03 * std::sin(20 * t);
  }
  const Points carried = applyDeformation(mesh, bent, way);
  for (int i = 1; i < STEPS; ++i)
    EXPECT_LT((carried.row(i) - carried.row(i - 1)).norm(),
              3 * (way.row(i) - way.row(i - 1)).norm());
}

TEST(ApplyDeformation, hasNoJumpsFarOffEither) {
  const TriangleMesh mesh = test::grid(40, 20, 2, 1);  // eight edges are 0.4
  const Points bent = test::bentStrip(40, 20, 2, 1, 0.5).vertices;
  constexpr int STEPS = 4000;
  Points way(STEPS, 3);
  for (int i = 0; i < STEPS; ++i) {
    const double t = static_cast<double>(i) / STEPS;
    way.row(i) << 0.3 + 1.4 * t, 0.3 + 0.4 * t, 0.2 + t;
  }
  const Points carried = applyDeformation(mesh, bent, way);
  for (int i = 1; i < STEPS; ++i)
    EXPECT_LT((carried.row(i) - carried.row(i - 1)).norm(),
              3 * (way.row(i) - way.row(i - 1)).norm())
        << way.row(i);
}

TEST(ApplyDeformation, takesLittleLongerForOutliers) {
  const TriangleMesh mesh = test::grid(150, 150, 1, 1);
  const Points bent = test::bentStrip(150, 150, 1, 1, 1.5).vertices;
  const auto secondsFor = [&](const Points& points) {
    return test::cpuSeconds([&] { EXPECT_TRUE(applyDeformation(mesh, bent, points).allFinite()); });
  };
  Points points = mesh.vertices;
  points.col(2).array() += 0.001;
  const double near = secondsFor(points);
  for (int v = 0; v < points.rows(); v += 20) points(v, 2) += 1 + 1e-4 * v;
  EXPECT_LT(secondsFor(points), 4 * near);
}

TEST(ApplyDeformation, aPartThatTouchesDoesNotDrag) {
  const TriangleMesh one = test::grid(10, 10, 1, 1);
  const TriangleMesh both = test::joined(one, test::shifted(one, {0, 0, 0.05}));
  Points apart = both.vertices;
  apart.bottomRows(one.vertices.rows()).col(2).array() += 5;  // the upper sheet leaves
  Points under(1, 3), over(1, 3);
  under << 0.52, 0.47, 0.01;
  over << 0.52, 0.47, 0.04;
  EXPECT_LT(gap(applyDeformation(both, apart, under), under), 1e-9);
  EXPECT_LT(gap(applyDeformation(both, apart, over), over.rowwise() + Eigen::RowVector3d(0, 0, 5)),
            1e-9);
}

TEST(TurnDirections, turnsWithTheWholeAndKeepsLengths) {
  const TriangleMesh mesh = test::sphere(2);
  const Points points = 3 * test::randomPoints(200, 4), directions = test::randomPoints(200, 5);
  const Points turned =
      turnDirections(mesh, moved(mesh.vertices, similarity()), points, directions);
  const Eigen::Matrix3d turn = similarity().rotation();
  EXPECT_LT(gap(turned, directions * turn.transpose()), 1e-6);
}

TEST(TurnDirections, takesNormalsAlongABend) {
  const double angle = 1.5;
  const TriangleMesh coarse = test::grid(20, 10, 2, 1), dense = test::grid(83, 41, 2, 1);
  const TriangleMesh bent = test::bentStrip(83, 41, 2, 1, angle);
  const Points turned = turnDirections(
      coarse, test::bentStrip(20, 10, 2, 1, angle).vertices, dense.vertices, vertexNormals(dense));
  // Those of the bent surface; an edge of the coarse one turns by 0.075 radians.
  EXPECT_LT(gap(turned, vertexNormals(bent)), 0.075);
}

TEST(ApplyDeformation, takesACloudAlongWithItsNormals) {
  const TriangleMesh mesh = test::sphere(2);
  PointCloud cloud;
  cloud.points = 2 * test::randomPoints(50, 4);
  cloud.normals = test::randomPoints(50, 5);
  constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
  cloud.points.row(7).setConstant(NONE);
  cloud.normals.row(8).setConstant(NONE);
  cloud.normals.row(9).setZero();
  const PointCloud carried = applyDeformation({mesh, moved(mesh.vertices, similarity())}, cloud);
  const Points places = moved(cloud.points, similarity());
  const Points origin = Points::Zero(1, 3);
  const Points turned =
      moved(cloud.normals, similarity()).rowwise() - moved(origin, similarity()).row(0);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(carried.points.row(i).allFinite(), i != 7);
    if (i != 7) {
      EXPECT_LT((carried.points.row(i) - places.row(i)).norm(), 1e-6);
    }
    if (i == 7 || i == 9) {
      EXPECT_EQ(carried.normals.row(i), cloud.normals.row(i));
    } else if (i != 8) {
      EXPECT_LT((carried.normals.row(i).normalized() - turned.row(i).normalized()).norm(), 1e-6);
    }
  }
  EXPECT_FALSE(carried.normals.row(8).allFinite());
}

TEST(JoinedSurface, facetsThatShareNoVerticesAreJoined) {
  const TriangleMesh whole = test::sphere(1);
  TriangleMesh facets;
  facets.vertices.resize(3 * whole.faces.rows() + 1, 3);
  facets.faces.resize(whole.faces.rows(), 3);
  for (int i = 0; i < whole.faces.size(); ++i) {
    facets.vertices.row(i) = whole.vertices.row(whole.faces.data()[i]);
    facets.faces.data()[i] = i;
  }
  facets.vertices.bottomRows(1) << 9, 9, 9;  // in no face
  const DeformedSurface joined = joinedSurface(facets, 2 * facets.vertices);
  EXPECT_EQ(joined.rest.vertices.rows(), whole.vertices.rows());
  EXPECT_EQ(joined.rest.faces.rows(), whole.faces.rows());
  EXPECT_EQ(joined.deformed, 2 * joined.rest.vertices);
}

TEST(JoinedSurface, facetsAreJoinedOnEveryPart) {
  const TriangleMesh one = test::sphere(2);
  const TriangleMesh other = test::shifted({0.5 * one.vertices, one.faces}, {3, 0, 0});
  const TriangleMesh facets = test::soup(test::joined(one, other));
  const DeformedSurface joined = joinedSurface(facets, 2 * facets.vertices);
  EXPECT_EQ(joined.rest.vertices.rows(), 2 * one.vertices.rows());
  EXPECT_EQ(joined.rest.faces.rows(), 2 * one.faces.rows());
  EXPECT_EQ(connectedParts(joined.rest).area.size(), 2U);
  EXPECT_EQ(joined.deformed, 2 * joined.rest.vertices);
  for (int i = 0; i < facets.faces.size(); ++i)
    EXPECT_EQ(joined.rest.vertices.row(joined.rest.faces.data()[i]),
              facets.vertices.row(facets.faces.data()[i]));
}

TEST(ApplyDeformation, refusesWhatDoesNotFit) {
  const TriangleMesh mesh = test::sphere(1);
  EXPECT_THROW(applyDeformation(mesh, mesh.vertices.topRows(4), mesh.vertices),
               std::invalid_argument);
  EXPECT_THROW(applyDeformation({}, Points(0, 3), mesh.vertices), std::invalid_argument);
  TriangleMesh no_corner = mesh;
  no_corner.faces(0, 1) = static_cast<int>(mesh.vertices.rows());
  EXPECT_THROW(applyDeformation(no_corner, mesh.vertices, mesh.vertices), std::invalid_argument);
  EXPECT_THROW(turnDirections(mesh, mesh.vertices, mesh.vertices, Points(1, 3)),
               std::invalid_argument);
  EXPECT_EQ(applyDeformation(mesh, mesh.vertices, Points(0, 3)).rows(), 0);
}

}  // namespace
}  // namespace posture
