// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/spikes.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// A cone of a single ring, its base left open: the tip is vertex `around`.
TriangleMesh cone(int around, double height) {
  TriangleMesh mesh{Points(around + 1, 3), Faces(around, 3)};
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * M_PI * i / around;
    mesh.vertices.row(i) << std::cos(angle), std::sin(angle), 0;
    mesh.faces.row(i) << i, (i + 1) % around, around;
  }
  mesh.vertices.row(around) << 0, 0, height;
  return mesh;
}

/// Two rings of vertices and nothing between them.
TriangleMesh tube(int around, double height) {
  TriangleMesh mesh{Points(2 * around, 3), Faces(2 * around, 3)};
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * M_PI * i / around;
    const int next = (i + 1) % around;
    mesh.vertices.row(i) << std::cos(angle), std::sin(angle), 0;
    mesh.vertices.row(around + i) << std::cos(angle), std::sin(angle), height;
    mesh.faces.row(2 * i) << i, next, around + i;
    mesh.faces.row(2 * i + 1) << next, around + next, around + i;
  }
  return mesh;
}

class Spikes : public testing::Test {
 protected:
  void throwOut(int v, const Eigen::RowVector3d& by) { spiky_.vertices.row(v) += by; }

  const TriangleMesh sphere_ = test::sphere(4);  // edges of about 0.07
  const double edge_ = meanEdgeLength(sphere_);
  TriangleMesh spiky_ = sphere_;
};

TEST_F(Spikes, doNotDependOnHowTheMeshIsTurned) {
  // Tips of all heights, about the limit among them.
  for (double height = 4; height < 6; height += 0.01) {
    TriangleMesh tip = cone(5, height);
    tip.vertices.col(0).head(5) *= 1.6;  // no circle
    const int as_it_is = setSpikesBack(tip);
    for (double angle : {0.3, 1.1, 2.0}) {
      TriangleMesh turned = cone(5, height);
      turned.vertices.col(0).head(5) *= 1.6;
      turned.vertices *= Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
      EXPECT_EQ(setSpikesBack(turned), as_it_is) << height << " turned by " << angle;
    }
  }
}

TEST_F(Spikes, areSetBackAndNothingElseMoves) {
  const std::vector<int> out{7, 300, 1111};
  throwOut(7, {3, 0, 0});
  throwOut(300, {0, -1e9, 1e9});
  throwOut(1111, {0, 0, 1e200});
  EXPECT_EQ(setSpikesBack(spiky_), 3);
  for (int v : out) EXPECT_LT((spiky_.vertices.row(v) - sphere_.vertices.row(v)).norm(), edge_);
  for (int v : out) spiky_.vertices.row(v) = sphere_.vertices.row(v);
  EXPECT_EQ(spiky_.vertices, sphere_.vertices);
  EXPECT_EQ(spiky_.faces, sphere_.faces);
}

TEST_F(Spikes, cornersOfNeedlesAreNone) {
  // The corner of a sheet, two of its three neighbours close together.
  TriangleMesh sheet{Points(6, 3), Faces(4, 3)};
  sheet.vertices << 0, 0, 0, 1, 0, 0, 1, 0.15, 0, 0, 1, 0, 2, 0.1, 0, 1, 1, 0;
  sheet.faces << 0, 1, 2, 0, 2, 3, 1, 4, 2, 2, 5, 3;
  EXPECT_EQ(setSpikesBack(sheet), 0);
  // A fan from the far corner of a plate to the vertices of a small hole.
  constexpr int AROUND = 12;
  TriangleMesh plate{Points(2 * AROUND + 1, 3), Faces(3 * AROUND - 3, 3)};
  const auto ring = [&](int i, double height, int row) {
    const double angle = M_PI / 2 * i / (AROUND - 1);
    plate.vertices.row(row) << 5 * std::cos(angle), 5 * std::sin(angle), height;
  };
  for (int i = 0; i < AROUND; ++i) {
    ring(i, 0, i);
    ring(i, -50, AROUND + i);
  }
  plate.vertices.row(2 * AROUND) << 60, 60, 0;
  for (int i = 0; i + 1 < AROUND; ++i) {
    plate.faces.row(3 * i) << i, 2 * AROUND, i + 1;
    plate.faces.row(3 * i + 1) << i, i + 1, AROUND + i;
    plate.faces.row(3 * i + 2) << i + 1, AROUND + i + 1, AROUND + i;
  }
  EXPECT_EQ(setSpikesBack(plate), 0);
}

TEST_F(Spikes, besideEachOther) {
  const int a = sphere_.faces(100, 0), b = sphere_.faces(100, 1);
  throwOut(a, {20, 0, 3});
  throwOut(b, {-3, 40, 0});
  EXPECT_EQ(setSpikesBack(spiky_), 2);
  for (int v : {a, b}) EXPECT_LT((spiky_.vertices.row(v) - sphere_.vertices.row(v)).norm(), edge_);
}

TEST_F(Spikes, oneBetweenSpikesIsToldOnceTheyAreBack) {
  std::vector<int> out;
  Rng rng(1);
  for (int v = 0; v < sphere_.vertices.rows(); ++v)
    if (rng.uniform() < 0.10) out.push_back(v);
  for (int v : out) {
    const double x = rng.normal(), y = rng.normal(), z = rng.normal();
    throwOut(v, 20 * Eigen::RowVector3d(x, y, z).normalized());
  }
  EXPECT_EQ(setSpikesBack(spiky_), static_cast<int>(out.size()));
  for (int v : out)
    EXPECT_LT((spiky_.vertices.row(v) - sphere_.vertices.row(v)).norm(), 2 * edge_) << v;
}

TEST_F(Spikes, ofFacetsThatShareNoVertices) {
  throwOut(42, {0, 5, 5});
  TriangleMesh loose = test::soup(spiky_);
  const TriangleMesh whole = test::soup(sphere_);
  EXPECT_EQ(setSpikesBack(loose), 1);
  EXPECT_LT((loose.vertices - whole.vertices).rowwise().norm().maxCoeff(), edge_);
}

TEST(SpikesOfBodies, areLeftAlone) {
  for (TriangleMesh mesh : {test::sphere(0),
                            test::torus(60, 4, 1, 0.01),
                            cone(60, 0),
                            cone(60, 4.5),
                            tube(60, 200),
                            test::grid(2, 40, 1, 1e4)}) {
    const Points before = mesh.vertices;
    EXPECT_EQ(setSpikesBack(mesh), 0);
    EXPECT_EQ(mesh.vertices, before);
  }
  TriangleMesh needle = cone(60, 5.5);
  EXPECT_EQ(setSpikesBack(needle), 1);
}

}  // namespace
}  // namespace posture
