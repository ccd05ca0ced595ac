// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/vertex_neighbors.h>

#include <gtest/gtest.h>

#include "attempts/leave_out_patches.h"
#include "sides/given_shape.h"
#include "sides/patched_shape.h"
#include "support/shapes.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

TEST(LeaveOutPatches, whatLiesBesideTheRimGoesToItAndTheRestHasNoCounterpart) {
  const TriangleMesh whole = test::sphere(5);
  TriangleMesh open = whole;
  int kept = 0;
  for (const auto& f : whole.faces.rowwise())
    if (whole.vertices(f[0], 2) < 0.97) open.faces.row(kept++) = f;
  open.faces.conservativeResize(kept, 3);
  const CleanMesh whole_clean = cleanMesh(whole), open_clean = cleanMesh(open);
  const GivenShape source{whole, whole_clean}, target{open, open_clean};
  const PatchedShape source_patched{whole, whole_clean},
      target_patched = withPatches(open, open_clean);
  ASSERT_EQ(target_patched.patched_holes, 1);
  const int n = static_cast<int>(open.vertices.rows());
  // One source vertex to each of the patch.
  RegistrationResult result;
  result.correspondence.on_target.resize(whole.vertices.rows());
  result.correspondence.confidence = Vector::Ones(whole.vertices.rows());
  result.deformed = whole.vertices;
  for (int i = 0; i < target_patched.patch_vertices; ++i)
    result.correspondence.on_target[i].vertex = n + i;
  leaveOutPatches(source, source_patched, target, target_patched, result);
  const std::vector<char> on_rim = boundaryVertices(open.faces, n);
  int beside = 0, within = 0;
  for (int i = 0; i < target_patched.patch_vertices; ++i) {
    double gap = 10;
    for (int v = 0; v < n; ++v)
      if (on_rim[v])
        gap =
            std::min(gap, (open.vertices.row(v) - target_patched.input.vertices.row(n + i)).norm());
    const int vertex = result.correspondence.on_target[i].vertex;
    // Edges are 0.03 to 0.04 long, 0.015 square roots of the area are 0.053.
    if (gap < 0.05) {
      ++beside;
      ASSERT_GE(vertex, 0);
      EXPECT_TRUE(on_rim[vertex]);
    } else if (gap > 0.06) {
      ++within;
      EXPECT_LT(vertex, 0);
      EXPECT_EQ(result.correspondence.confidence[i], 0);
    }
  }
  EXPECT_GT(beside, 20);
  EXPECT_GT(within, 20);
}

TEST(LeaveOutPatches, onAWideStripOnlyWhatIsBesideAVertexHasACounterpart) {
  // Two squares of surface and a strip of two long faces between them.
  const TriangleMesh square = test::grid(10, 10, 1, 1);
  const TriangleMesh two = test::joined(square, test::shifted(square, {1.5, 0, 0}));
  const CleanMesh clean = cleanMesh(two);
  const auto at = [&](double x, double y) {
    Eigen::Index nearest = 0;
    (two.vertices.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  };
  PatchedShape joined{two, clean};
  joined.joined_pieces = 1;
  const auto strip = two.faces.rows();
  joined.input.faces.conservativeResize(strip + 1, 3);
  joined.input.faces.row(strip) << at(1, 0), at(1.5, 0), at(1, 0.1);
  const PatchedShape as_given{two, clean};
  RegistrationResult result;
  result.correspondence.on_target.resize(two.vertices.rows());
  result.correspondence.confidence = Vector::Ones(two.vertices.rows());
  result.deformed = two.vertices;
  const auto face = static_cast<int>(strip);
  result.correspondence.on_target[0] = {at(1, 0), face, Eigen::Vector3d(0.9, 0.1, 0)};
  result.correspondence.on_target[1] = {at(1, 0), face, Eigen::Vector3d(0.6, 0.4, 0)};
  leaveOutPatches({two, clean}, as_given, {two, clean}, joined, result);
  EXPECT_EQ(result.correspondence.on_target[0].vertex, at(1, 0));
  EXPECT_LT(result.correspondence.on_target[0].face, face);
  EXPECT_LT(result.correspondence.on_target[1].vertex, 0);
  EXPECT_EQ(result.correspondence.confidence[1], 0);
}

}  // namespace
}  // namespace posture
