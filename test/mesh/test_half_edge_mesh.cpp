// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/half_edge_mesh.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace posture {
namespace {

int eulerNumber(const HalfEdgeMesh& mesh) {
  return mesh.liveVertexCount() - static_cast<int>(meshEdges(mesh.faces()).size()) +
         mesh.liveFaceCount();
}

HalfEdgeMesh halfEdges(const TriangleMesh& mesh) {
  return {mesh.faces, static_cast<int>(mesh.vertices.rows())};
}

TEST(HalfEdgeMesh, holdsItsInvariantsOnClosedAndOpenMeshes) {
  EXPECT_EQ(halfEdges(test::sphere(2)).check(), "");
  EXPECT_EQ(halfEdges(test::grid(5, 4, 1, 1)).check(), "");
}

TEST(HalfEdgeMesh, starMeetsEveryNeighbour) {
  const TriangleMesh grid = test::grid(3, 3, 1, 1);
  const HalfEdgeMesh mesh = halfEdges(grid);
  std::vector<int> degree(grid.vertices.rows(), 0);
  for (const Edge& e : meshEdges(grid.faces)) {
    ++degree[e.first];
    ++degree[e.second];
  }
  for (int v = 0; v < grid.vertices.rows(); ++v) EXPECT_EQ(mesh.neighbors(v).size(), degree[v]);
  EXPECT_TRUE(mesh.isBoundaryVertex(0));
  EXPECT_FALSE(mesh.isBoundaryVertex(5));
}

TEST(HalfEdgeMesh, boundaryLoopsAreTheRimsEachOnce) {
  TriangleMesh grid = test::grid(5, 4, 5, 4);
  // Without the two faces of the square between (2, 1) and (3, 2).
  std::vector<Eigen::RowVector3i> kept;
  for (const auto& face : grid.faces.rowwise()) {
    const Eigen::RowVector3d middle = grid.vertices(face, Eigen::all).colwise().mean();
    if (!(middle.x() > 2 && middle.x() < 3 && middle.y() > 1 && middle.y() < 2))
      kept.emplace_back(face);
  }
  grid.faces.resize(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t f = 0; f < kept.size(); ++f)
    grid.faces.row(static_cast<Eigen::Index>(f)) = kept[f];
  const HalfEdgeMesh mesh = halfEdges(grid);
  std::vector<std::vector<int>> loops = mesh.boundaryLoops();
  ASSERT_EQ(loops.size(), 2U);
  std::sort(loops.begin(), loops.end(), [](auto& x, auto& y) { return x.size() < y.size(); });
  EXPECT_EQ(loops[0].size(), 4U);
  EXPECT_EQ(loops[1].size(), 18U);
  for (const std::vector<int>& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      EXPECT_LT(mesh.twin(loop[k]), 0);
      EXPECT_EQ(mesh.target(loop[k]), mesh.origin(loop[(k + 1) % loop.size()]));
    }
  EXPECT_TRUE(halfEdges(test::sphere(2)).boundaryLoops().empty());
}

TEST(HalfEdgeMesh, refusesWhatIsNotManifoldOrNotOriented) {
  Faces fin(3, 3), against(2, 3), bow_tie(2, 3);
  fin << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  against << 0, 1, 2, 0, 1, 3;
  bow_tie << 0, 1, 2, 0, 3, 4;
  EXPECT_THROW(HalfEdgeMesh(fin, 5), std::invalid_argument);
  EXPECT_THROW(HalfEdgeMesh(against, 4), std::invalid_argument);
  EXPECT_THROW(HalfEdgeMesh(bow_tie, 5), std::invalid_argument);
}

/// Collapses edges at random as long as any may be; the topology must stay what it was.
void collapseAtRandom(const TriangleMesh& input, std::uint64_t seed) {
  HalfEdgeMesh mesh = halfEdges(input);
  const int euler = eulerNumber(mesh);
  Rng rng(seed);
  int collapsed = 0;
  for (int attempt = 0; attempt < 40 * input.vertices.rows(); ++attempt) {
    const int h = rng.below(mesh.halfEdgeCount());
    if (!mesh.isLive(h)) continue;
    const int from = mesh.origin(h), into = mesh.target(h);
    if (!mesh.canCollapse(from, into)) continue;
    const int faces = mesh.liveFaceCount(), vertices = mesh.liveVertexCount();
    mesh.collapse(from, into);
    ++collapsed;
    ASSERT_EQ(mesh.check(), "") << "after " << collapsed << " collapses";
    ASSERT_EQ(mesh.liveVertexCount(), vertices - 1);
    ASSERT_LT(mesh.liveFaceCount(), faces);
    ASSERT_EQ(eulerNumber(mesh), euler);
  }
  // Nearly everything can go from a sphere or a disc.
  EXPECT_GT(collapsed, input.vertices.rows() * 3 / 4);
}

TEST(HalfEdgeMesh, collapsesKeepInvariantsAndEulerNumberOnASphere) {
  collapseAtRandom(test::sphere(2), 1);
}

TEST(HalfEdgeMesh, collapsesKeepInvariantsAndEulerNumberOnADisc) {
  collapseAtRandom(test::grid(9, 7, 1, 1), 2);
}

TEST(HalfEdgeMesh, keepsATetrahedronFromFoldingFlat) {
  Faces tetrahedron(4, 3);
  tetrahedron << 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2;
  const HalfEdgeMesh mesh(tetrahedron, 4);
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) EXPECT_TRUE(a == b || !mesh.canCollapse(a, b));
}

TEST(HalfEdgeMesh, doesNotPinchTwoBoundariesTogether) {
  // A ring of six triangles about a hole: an edge across the ring joins two boundaries.
  Faces ring(6, 3);
  ring << 0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5;
  const HalfEdgeMesh mesh(ring, 6);
  EXPECT_FALSE(mesh.canCollapse(1, 3));
  EXPECT_FALSE(mesh.canCollapse(0, 3));
}

/// What the quadrilateral about the edge of h has for corners: its ends, then the other two.
std::array<int, 4> quadrilateral(const HalfEdgeMesh& mesh, int h) {
  return {mesh.origin(h),
          mesh.target(h),
          mesh.origin(HalfEdgeMesh::previous(h)),
          mesh.origin(HalfEdgeMesh::previous(mesh.twin(h)))};
}

std::set<std::pair<int, int>> edgeSet(const HalfEdgeMesh& mesh) {
  std::set<std::pair<int, int>> edges;
  for (const Edge& e : meshEdges(mesh.faces())) edges.insert({e.first, e.second});
  return edges;
}

/// Flips and collapses edges at random; the topology must stay what it was.
void changeAtRandom(const TriangleMesh& input, std::uint64_t seed) {
  HalfEdgeMesh mesh = halfEdges(input);
  const int euler = eulerNumber(mesh);
  Rng rng(seed);
  int flipped = 0, collapsed = 0;
  for (int attempt = 0; attempt < 10 * input.vertices.rows(); ++attempt) {
    const int h = rng.below(mesh.halfEdgeCount());
    if (!mesh.isLive(h)) continue;
    const int faces = mesh.liveFaceCount(), vertices = mesh.liveVertexCount();
    if (rng.uniform() < 0.1) {
      if (!mesh.canCollapse(mesh.origin(h), mesh.target(h))) continue;
      mesh.collapse(mesh.origin(h), mesh.target(h));
      ++collapsed;
    } else {
      if (!mesh.canFlip(h)) continue;
      mesh.flip(h);
      ++flipped;
      ASSERT_EQ(mesh.liveFaceCount(), faces);
      ASSERT_EQ(mesh.liveVertexCount(), vertices);
    }
    ASSERT_EQ(mesh.check(), "") << "after " << flipped << " flips, " << collapsed << " collapses";
    ASSERT_EQ(eulerNumber(mesh), euler);
  }
  EXPECT_GT(flipped, input.vertices.rows());
  EXPECT_GT(collapsed, input.vertices.rows() / 4);
}

TEST(HalfEdgeMesh, flipsAndCollapsesKeepInvariantsAndEulerNumber) {
  changeAtRandom(test::sphere(2), 3);
  changeAtRandom(test::grid(9, 7, 1, 1), 4);
}

TEST(HalfEdgeMesh, aFlipChangesOneEdgeAndTheNextTakesItBack) {
  for (const TriangleMesh& input : {test::sphere(2), test::grid(9, 7, 1, 1)}) {
    HalfEdgeMesh mesh = halfEdges(input);
    int flipped = 0;
    for (int h = 0; h < mesh.halfEdgeCount(); ++h) {
      if (!mesh.canFlip(h)) continue;
      ++flipped;
      const std::set<std::pair<int, int>> before = edgeSet(mesh);
      const auto [a, b, c, d] = quadrilateral(mesh, h);
      std::set<std::pair<int, int>> expected = before;
      expected.erase(std::minmax(a, b));
      expected.insert(std::minmax(c, d));
      mesh.flip(h);
      ASSERT_EQ(mesh.check(), "");
      ASSERT_EQ(edgeSet(mesh), expected);
      ASSERT_TRUE(mesh.canFlip(h));
      mesh.flip(h);
      ASSERT_EQ(mesh.check(), "");
      ASSERT_EQ(edgeSet(mesh), before);
    }
    EXPECT_GT(flipped, input.vertices.rows());
  }
}

TEST(HalfEdgeMesh, aFlipKeepsThePlaneCovered) {
  // A convex quadrilateral: both ways of cutting it face upwards.
  TriangleMesh square = test::grid(1, 1, 1, 1);
  HalfEdgeMesh mesh = halfEdges(square);
  for (int h = 0; h < mesh.halfEdgeCount(); ++h) {
    if (mesh.twin(h) < 0) continue;
    mesh.flip(h);
    square.faces = mesh.faces();
    for (int f = 0; f < 2; ++f) {
      const Eigen::Vector3d a = square.vertices.row(square.faces(f, 0)),
                            b = square.vertices.row(square.faces(f, 1)),
                            c = square.vertices.row(square.faces(f, 2));
      EXPECT_EQ((b - a).cross(c - a), Eigen::Vector3d(0, 0, 1));
    }
  }
}

TEST(HalfEdgeMesh, flipsExactlyWhatHasTwoFacesAndNewEndsNotJoined) {
  // Flips at random make vertices of few neighbours, whose edges cannot all be flipped.
  for (const TriangleMesh& input : {test::sphere(2), test::grid(9, 7, 1, 1)}) {
    HalfEdgeMesh mesh = halfEdges(input);
    Rng rng(5);
    for (int i = 0; i < 2000; ++i) {
      const int h = rng.below(mesh.halfEdgeCount());
      if (mesh.canFlip(h)) mesh.flip(h);
    }
    const std::set<std::pair<int, int>> edges = edgeSet(mesh);
    int joined = 0;
    for (int h = 0; h < mesh.halfEdgeCount(); ++h) {
      if (mesh.twin(h) < 0) {
        EXPECT_FALSE(mesh.canFlip(h)) << "on the boundary";
        continue;
      }
      const auto [a, b, c, d] = quadrilateral(mesh, h);
      const bool are_joined = edges.count(std::minmax(c, d)) > 0;
      joined += are_joined;
      EXPECT_EQ(mesh.canFlip(h), !are_joined);
    }
    EXPECT_GT(joined, 10);
  }
}

TEST(HalfEdgeMesh, flipsNoEdgeWhoseNewEndsAreJoinedOnTheBoundary) {
  // The edge 2 3 is a side of one face only: it runs from 3 to 2.
  Faces disc(5, 3);
  disc << 0, 1, 2, 1, 0, 3, 1, 3, 4, 3, 2, 4, 2, 1, 4;
  const HalfEdgeMesh mesh(disc, 5);
  EXPECT_FALSE(mesh.canFlip(0));
  EXPECT_FALSE(mesh.canFlip(mesh.twin(0)));
}

TEST(HalfEdgeMesh, flipsNoEdgeOfATetrahedronNorOfTwoFacesBackToBack) {
  Faces tetrahedron(4, 3), pillow(2, 3);
  tetrahedron << 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2;
  pillow << 0, 1, 2, 1, 0, 2;
  for (const HalfEdgeMesh& mesh : {HalfEdgeMesh(tetrahedron, 4), HalfEdgeMesh(pillow, 3)})
    for (int h = 0; h < mesh.halfEdgeCount(); ++h) EXPECT_FALSE(mesh.canFlip(h));
}

TEST(CutNonManifold, separatesFinsBowTiesAndDisagreeingFaces) {
  TriangleMesh mesh;
  mesh.vertices = Points::Random(9, 3);
  mesh.faces.resize(5, 3);
  mesh.faces << 0, 1, 2, 1, 0, 3, 0, 1, 4,  // a fin on the edge 0 1
      5, 6, 7, 5, 8, 2;                     // a bow-tie at 5
  const ManifoldMesh cut = cutNonManifold(mesh);
  EXPECT_EQ(HalfEdgeMesh(cut.mesh.faces, static_cast<int>(cut.mesh.vertices.rows())).check(), "");
  for (int i = 0; i < mesh.faces.size(); ++i)
    EXPECT_EQ(cut.original_vertex[cut.mesh.faces.data()[i]], mesh.faces.data()[i]);
  for (int v = 0; v < cut.mesh.vertices.rows(); ++v)
    EXPECT_EQ(cut.mesh.vertices.row(v), mesh.vertices.row(cut.original_vertex[v]));
}

TEST(CutNonManifold, leavesAManifoldAsItIs) {
  const TriangleMesh sphere = test::sphere(2);
  const ManifoldMesh cut = cutNonManifold(sphere);
  EXPECT_EQ(cut.mesh.faces, sphere.faces);
  EXPECT_EQ(cut.mesh.vertices.rows(), sphere.vertices.rows());
}

}  // namespace
}  // namespace posture
