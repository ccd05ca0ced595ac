// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/split_long_edges.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace posture {
namespace {

/// x -> x^3 and so on: faces of all sizes.
TriangleMesh uneven(TriangleMesh mesh) {
  mesh.vertices = mesh.vertices.array() + 0.3 * mesh.vertices.array().cube() +
                  0.01 * test::randomPoints(static_cast<int>(mesh.vertices.rows()), 1).array();
  return mesh;
}

/// The length of the edges that so many faces share.
double lengthOf(const TriangleMesh& mesh, int faces) {
  double length = 0;
  for (const Edge& e : meshEdges(mesh.faces))
    if (e.faces == faces)
      length += (mesh.vertices.row(e.first) - mesh.vertices.row(e.second)).norm();
  return length;
}

double leastAngle(const TriangleMesh& mesh) {
  double least = M_PI;
  for (const auto& face : mesh.faces.rowwise())
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d at = mesh.vertices.row(face[k]);
      const Eigen::Vector3d u = mesh.vertices.row(face[(k + 1) % 3]).transpose() - at,
                            v = mesh.vertices.row(face[(k + 2) % 3]).transpose() - at;
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  return least;
}

/// Given vertices first; every part in its face, looking the same way, all of it covered.
void expectSameSurface(const TriangleMesh& given, const SplitMesh& split) {
  const auto n = given.vertices.rows();
  ASSERT_GE(split.mesh.vertices.rows(), n);
  EXPECT_EQ(split.mesh.vertices.topRows(n), given.vertices);
  ASSERT_EQ(split.parts.size(), split.mesh.faces.rows());
  Points covered = Points::Zero(given.faces.rows(), 3);
  const auto normal = [](const TriangleMesh& mesh, int f) -> Eigen::RowVector3d {
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(f, 0));
    return (mesh.vertices.row(mesh.faces(f, 1)) - a).cross(mesh.vertices.row(mesh.faces(f, 2)) - a);
  };
  const double size = given.vertices.cwiseAbs().maxCoeff();
  for (int f = 0; f < split.mesh.faces.rows(); ++f) {
    const FacePart& part = split.parts[f];
    ASSERT_GE(part.corners.minCoeff(), 0);
    ASSERT_EQ(part.corners.colwise().sum(), Eigen::RowVector3d::Ones());
    for (int k = 0; k < 3; ++k) {
      Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
      for (int c = 0; c < 3; ++c)
        place += part.corners(c, k) * given.vertices.row(given.faces(part.face, c));
      ASSERT_LT((place - split.mesh.vertices.row(split.mesh.faces(f, k))).norm(), 1e-13 * size);
    }
    covered.row(part.face) += normal(split.mesh, f);
  }
  for (int f = 0; f < given.faces.rows(); ++f)
    ASSERT_LT((covered.row(f) - normal(given, f)).norm(), 1e-12 * size * size);
  EXPECT_NEAR(faceAreas(split.mesh).sum(), faceAreas(given).sum(), 1e-12 * size * size);
}

TEST(SplitLongEdges, putsVerticesOnTheSameSurface) {
  const TriangleMesh given = uneven(test::sphere(2));
  const SplitMesh split = splitLongEdges(given, 1000);
  EXPECT_EQ(split.mesh.vertices.rows(), 1000);
  EXPECT_EQ(split.mesh.faces.rows(), 2 * (1000 - 2));  // still a sphere
  expectSameSurface(given, split);
  EXPECT_NO_THROW(HalfEdgeMesh(split.mesh.faces, 1000));
  EXPECT_EQ(lengthOf(split.mesh, 1), 0);
  EXPECT_GE(leastAngle(split.mesh), leastAngle(given) / 2);
  EXPECT_LT(coarseness(split.mesh), 0.5 * coarseness(given));
}

TEST(SplitLongEdges, keepsRims) {
  const TriangleMesh given = uneven(test::grid(7, 4, 3, 1));
  const SplitMesh split = splitLongEdges(given, 333);
  EXPECT_EQ(split.mesh.vertices.rows(), 333);
  expectSameSurface(given, split);
  EXPECT_NO_THROW(HalfEdgeMesh(split.mesh.faces, 333));
  EXPECT_NEAR(lengthOf(split.mesh, 1), lengthOf(given, 1), 1e-12);
}

TEST(SplitLongEdges, splitsAllFacesAtAnEdge) {
  TriangleMesh given;
  given.vertices.resize(5, 3);
  given.vertices << 0, 0, 0, 0, 0, 4, 1, 0, 2, -1, 0.5, 2, 0, -1, 1;
  given.faces.resize(3, 3);
  given.faces << 0, 1, 2, 0, 1, 3, 4, 1, 0;
  const SplitMesh split = splitLongEdges(given, 200);
  EXPECT_EQ(split.mesh.vertices.rows(), 200);
  expectSameSurface(given, split);
  EXPECT_EQ(lengthOf(split.mesh, 3), 4);
}

TEST(SplitLongEdges, leavesWhatIsFineEnough) {
  const TriangleMesh given = test::sphere(2);
  for (const int count : {0, static_cast<int>(given.vertices.rows())}) {
    const SplitMesh split = splitLongEdges(given, count);
    EXPECT_EQ(split.mesh.vertices, given.vertices);
    EXPECT_EQ(split.mesh.faces, given.faces);
    expectSameSurface(given, split);
  }
}

TEST(SplitLongEdges, doesNotDependOnTheOrderOfVerticesAndFaces) {
  // All edges of equal length many times over.
  for (const TriangleMesh& given : {test::grid(6, 6, 1, 1), uneven(test::sphere(1))}) {
    const int n = static_cast<int>(given.vertices.rows()), m = static_cast<int>(given.faces.rows());
    std::vector<int> vertex(n), face(m);
    std::iota(vertex.begin(), vertex.end(), 0);
    std::iota(face.begin(), face.end(), 0);
    std::mt19937 random(3);
    std::shuffle(vertex.begin(), vertex.end(), random);
    std::shuffle(face.begin(), face.end(), random);
    TriangleMesh other = given;
    for (int v = 0; v < n; ++v) other.vertices.row(vertex[v]) = given.vertices.row(v);
    for (int f = 0; f < m; ++f)
      for (int k = 0; k < 3; ++k) other.faces(face[f], (k + f) % 3) = vertex[given.faces(f, k)];
    const SplitMesh one = splitLongEdges(given, 3 * n + 5), two = splitLongEdges(other, 3 * n + 5);
    EXPECT_EQ(one.mesh.vertices.bottomRows(2 * n + 5), two.mesh.vertices.bottomRows(2 * n + 5));
    using Place = std::array<double, 3>;
    const auto places = [](const TriangleMesh& mesh) {
      std::vector<std::array<Place, 3>> faces;
      for (const auto& f : mesh.faces.rowwise()) {
        std::array<Place, 3> corners{};
        for (int k = 0; k < 3; ++k)
          for (int c = 0; c < 3; ++c) corners[k][c] = mesh.vertices(f[k], c);
        std::rotate(
            corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        faces.push_back(corners);
      }
      std::sort(faces.begin(), faces.end());
      return faces;
    };
    EXPECT_EQ(places(one.mesh), places(two.mesh));
  }
}

TEST(SplitLongEdges, makesSmallFacesOfAHugeOneAndOfThinOnes) {
  TriangleMesh one;
  one.vertices.resize(3, 3);
  one.vertices << 0, 0, 0, 9e5, 0, 0, 1e5, 7e5, 0;
  one.faces.resize(1, 3);
  one.faces << 0, 1, 2;
  TriangleMesh comb = test::grid(400, 1, 1, 1000);  // faces 400,000 times as long as wide
  for (const TriangleMesh& given : {one, comb}) {
    const SplitMesh split = splitLongEdges(given, 5000);
    EXPECT_EQ(split.mesh.vertices.rows(), 5000);
    expectSameSurface(given, split);
    EXPECT_NO_THROW(HalfEdgeMesh(split.mesh.faces, 5000));
    EXPECT_GE(leastAngle(split.mesh), 0.5 * leastAngle(given));
  }
  EXPECT_LT(coarseness(splitLongEdges(one, 5000).mesh), 0.05);
}

TEST(SplitLongEdges, makesNoVertexWhereOneIs) {
  // A face without area, its third corner in the middle of the long edge; and one with an edge
  // without length.
  TriangleMesh flat;
  flat.vertices.resize(6, 3);
  flat.vertices << 0, 0, 0, 4, 0, 0, 2, 0, 0, 2, 3, 0, 7, 7, 7, 7, 7, 7;
  flat.faces.resize(3, 3);
  flat.faces << 0, 2, 1, 0, 1, 3, 4, 5, 0;
  const SplitMesh split = splitLongEdges(flat, 50);
  EXPECT_EQ(split.mesh.vertices.rows(), 50);
  for (int v = 6; v < 50; ++v)
    for (int w = 0; w < 6; ++w)
      EXPECT_GT((split.mesh.vertices.row(v) - split.mesh.vertices.row(w)).norm(), 0);

  TriangleMesh point;
  point.vertices = Points::Ones(3, 3);
  point.faces.resize(1, 3);
  point.faces << 0, 1, 2;
  EXPECT_EQ(splitLongEdges(point, 50).mesh.vertices.rows(), 3);
  EXPECT_EQ(coarseness(point), 0);
}

}  // namespace
}  // namespace posture
