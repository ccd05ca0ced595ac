// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/handles.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <numeric>
#include <set>
#include <utility>

namespace posture {
namespace {

TriangleMesh withoutFaces(TriangleMesh mesh, int first, int count) {
  const Faces rest = mesh.faces.bottomRows(mesh.faces.rows() - first - count);
  mesh.faces.middleRows(first, rest.rows()) = rest;
  mesh.faces.conservativeResize(mesh.faces.rows() - count, 3);
  return mesh;
}

double lengthOf(const TriangleMesh& mesh, const std::vector<int>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += (mesh.vertices.row(loop[i]) - mesh.vertices.row(loop[(i + 1) % loop.size()])).norm();
  return sum;
}

/// Into how many parts the faces fall when none is joined across a step of the loops.
int partsBetween(const TriangleMesh& mesh, const std::vector<std::vector<int>>& loops) {
  std::set<std::pair<int, int>> cut;
  for (const std::vector<int>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      cut.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
  const Faces across = facesAcross(mesh.faces);
  std::vector<char> seen(mesh.faces.rows(), 0);
  int parts = 0;
  for (int start = 0; start < mesh.faces.rows(); ++start) {
    if (seen[start]) continue;
    ++parts;
    seen[start] = 1;
    std::vector<int> open{start};
    while (!open.empty()) {
      const int f = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int g = across(f, k);
        const auto side = std::minmax(mesh.faces(f, k), mesh.faces(f, (k + 1) % 3));
        if (g < 0 || seen[g] || cut.count(side)) continue;
        seen[g] = 1;
        open.push_back(g);
      }
    }
  }
  return parts;
}

TEST(Handles, areCountedWhateverHolesAndPartsThereAre) {
  const TriangleMesh ring = test::torus(24, 12, 2, 0.5);
  EXPECT_EQ(Handles(test::sphere(2)).count(), 0);
  EXPECT_EQ(Handles(test::grid(5, 4, 1, 1)).count(), 0);
  EXPECT_EQ(Handles(withoutFaces(test::sphere(2), 40, 1)).count(), 0);
  EXPECT_EQ(Handles(ring).count(), 1);
  EXPECT_EQ(Handles(withoutFaces(ring, 100, 2)).count(), 1);
  // Without all faces at one place around, it is an open tube.
  EXPECT_EQ(Handles(withoutFaces(ring, 24, 24)).count(), 0);
  EXPECT_EQ(Handles(test::joined(ring, ring)).count(), 2);
  EXPECT_EQ(Handles(test::joined(ring, test::sphere(1))).count(), 1);
  EXPECT_EQ(Handles(test::fused(ring, 0, 12 * 12)).count(), 2);
}

TEST(Handles, loopsAreClosedWaysThatDoNotPartTheSurface) {
  const TriangleMesh mesh = test::fused(test::torus(24, 12, 2, 0.5), 0, 12 * 12);
  const Handles handles(mesh);
  ASSERT_EQ(handles.count(), 2);
  std::set<std::pair<int, int>> edges;
  for (const Edge& e : meshEdges(mesh.faces)) edges.emplace(e.first, e.second);
  for (int base : {5, 77, 200}) {
    const auto loops = handles.loopsThrough(base);
    ASSERT_EQ(loops.size(), 4);
    double last = 0;
    for (const std::vector<int>& loop : loops) {
      EXPECT_EQ(std::set<int>(loop.begin(), loop.end()).size(), loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_TRUE(edges.count(std::minmax(loop[i], loop[(i + 1) % loop.size()])));
      EXPECT_EQ(partsBetween(mesh, {loop}), 1);
      EXPECT_GE(lengthOf(mesh, loop), last);
      last = lengthOf(mesh, loop);
    }
    EXPECT_EQ(partsBetween(mesh, loops), 1);
  }
}

TEST(Handles, loopsOfATorusGoAcrossAndAround) {
  constexpr double TURN = 2 * 3.141592653589793;
  const TriangleMesh mesh = test::torus(60, 30, 2, 0.5);
  for (int base : {0, 15, 900}) {  // outermost, innermost, outermost
    const auto loops = Handles(mesh).loopsThrough(base);
    ASSERT_EQ(loops.size(), 2);
    // A regular polygon of 30 corners is a little shorter than its circle; edges are no straighter
    // than the surface, so nothing is below the innermost circle's.
    EXPECT_NEAR(lengthOf(mesh, loops[0]), TURN * 0.5, 0.01 * TURN * 0.5);
    EXPECT_GT(lengthOf(mesh, loops[1]), 0.99 * TURN * 1.5);
    EXPECT_LT(lengthOf(mesh, loops[1]), TURN * 2.5);
  }
}

TEST(Handles, areNoneOnASphere) { EXPECT_TRUE(Handles(test::sphere(2)).loopsThrough(3).empty()); }

}  // namespace
}  // namespace posture
