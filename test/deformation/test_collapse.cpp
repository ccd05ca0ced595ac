// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/deformation/collapse.h>
#include <posture/mesh/half_edge_mesh.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include "support/topology.h"
#include <algorithm>
#include <cmath>
#include <set>

namespace posture {
namespace {

std::vector<char> keepAtRandom(int count, double share, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<char> keep(count);
  for (char& k : keep) k = rng.uniform() < share;
  return keep;
}

double volume(const Points& vertices, const Faces& faces) {
  double sum = 0;
  for (int f = 0; f < faces.rows(); ++f) {
    const Eigen::RowVector3d a = vertices.row(faces(f, 0)), b = vertices.row(faces(f, 1)),
                             c = vertices.row(faces(f, 2));
    sum += a.dot(b.cross(c)) / 6;
  }
  return sum;
}

/// Of the vertices in faces.
int eulerNumber(const Faces& faces) {
  const std::set<int> vertices(faces.data(), faces.data() + faces.size());
  return test::eulerNumber(static_cast<int>(vertices.size()), faces);
}

TEST(CollapseToVertices, leavesExactlyTheKeptOnes) {
  const TriangleMesh sphere = test::sphere(3);
  const int n = static_cast<int>(sphere.vertices.rows());
  for (double share : {0.9, 0.5, 0.1}) {
    const std::vector<char> keep = keepAtRandom(n, share, 1);
    const Faces faces = collapseToVertices(sphere, keep);
    const std::set<int> left(faces.data(), faces.data() + faces.size());
    EXPECT_EQ(static_cast<long>(left.size()), std::count(keep.begin(), keep.end(), 1));
    for (int v : left) EXPECT_TRUE(keep[v]);
    EXPECT_EQ(eulerNumber(faces), 2);
    EXPECT_EQ(HalfEdgeMesh(faces, n).check(), "");
  }
}

TEST(CollapseToVertices, keepsAHoleAHole) {
  TriangleMesh sphere = test::sphere(3);
  sphere.faces = sphere.faces.topRows(sphere.faces.rows() - 16).eval();
  const int euler = eulerNumber(sphere.faces);
  const int n = static_cast<int>(sphere.vertices.rows());
  const Faces faces = collapseToVertices(sphere, keepAtRandom(n, 0.4, 2));
  EXPECT_EQ(eulerNumber(faces), euler);
  EXPECT_EQ(HalfEdgeMesh(faces, n).check(), "");
}

TEST(CollapseToVertices, keepsTheVolumeBetterThanTheSquareOfTheSpacingSays) {
  const TriangleMesh sphere = test::sphere(4);
  const int n = static_cast<int>(sphere.vertices.rows());
  const std::vector<char> keep = keepAtRandom(n, 0.25, 3);
  const double before = volume(sphere.vertices, sphere.faces);
  const double after = volume(sphere.vertices, collapseToVertices(sphere, keep));
  // Edges of length e inscribed in the unit sphere sink its faces by about e^2 / 4 of the volume.
  // Random vertices lie less evenly: their squared edges are about twice as long.
  const double edge_sq = 4 * 3.14159 / (0.25 * n) * 2 / std::sqrt(3.0);
  EXPECT_LT(std::abs(before - after) / before, 2 * 2 * edge_sq / 4);
}

TEST(CollapseToVertices, costsNothingInAPlane) {
  // Collapsing a flat sheet changes no volume; it must stay flat, whole and unfolded.
  const TriangleMesh sheet = test::grid(12, 12, 1, 1);
  std::vector<char> keep = keepAtRandom(static_cast<int>(sheet.vertices.rows()), 0.3, 4);
  for (int corner : {0, 12, 13 * 12, 13 * 13 - 1}) keep[corner] = 1;
  const Faces faces = collapseToVertices(sheet, keep);
  double area = 0;
  for (int f = 0; f < faces.rows(); ++f) {
    const Eigen::RowVector3d a = sheet.vertices.row(faces(f, 0)),
                             b = sheet.vertices.row(faces(f, 1)),
                             c = sheet.vertices.row(faces(f, 2));
    const double signed_area = (b - a).cross(c - a).z() / 2;
    EXPECT_GT(signed_area, -1e-12) << "a face was flipped";
    area += signed_area;
  }
  EXPECT_NEAR(area, 1, 1e-9);
}

TEST(CollapseToVertices, takesNonManifoldInput) {
  TriangleMesh mesh = test::sphere(2);
  const int n = static_cast<int>(mesh.vertices.rows());
  mesh.vertices.conservativeResize(n + 1, 3);
  mesh.vertices.row(n) << 2, 0, 0;
  mesh.faces.conservativeResize(mesh.faces.rows() + 1, 3);
  mesh.faces.row(mesh.faces.rows() - 1) << mesh.faces(0, 0), mesh.faces(0, 1), n;
  const std::vector<char> keep = keepAtRandom(n + 1, 0.5, 5);
  const Faces faces = collapseToVertices(mesh, keep);
  for (int i = 0; i < faces.size(); ++i) EXPECT_TRUE(keep[faces.data()[i]]);
  EXPECT_GT(faces.rows(), 0);
}

TEST(CollapseToVertices, isEmptyWhenTooFewAreKept) {
  const TriangleMesh sphere = test::sphere(2);
  std::vector<char> keep(sphere.vertices.rows(), 0);
  EXPECT_EQ(collapseToVertices(sphere, keep).rows(), 0);
  keep[3] = keep[9] = 1;
  EXPECT_EQ(collapseToVertices(sphere, keep).rows(), 0);
}

TEST(CollapseToVertices, refusesFlagsThatDoNotFit) {
  EXPECT_THROW(collapseToVertices(test::sphere(0), {1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace posture
