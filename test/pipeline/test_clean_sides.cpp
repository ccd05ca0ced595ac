// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/normals.h>

#include <gtest/gtest.h>

#include "sides/clean_sides.h"
#include "support/files.h"
#include "support/shapes.h"
#include <string>

namespace posture {
namespace {

/// Half a sphere or a whole one.
TriangleMesh ball(bool half, bool inside_out) {
  TriangleMesh mesh = test::sphere(3);
  int kept = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    if (!half || mesh.vertices(mesh.faces(f, 0), 2) <= 0)
      mesh.faces.row(kept++) = mesh.faces.row(f).eval();
  mesh.faces.conservativeResize(kept, 3);
  if (inside_out) mesh.faces.col(0).swap(mesh.faces.col(1));
  return mesh;
}

bool looksOutward(const CleanMesh& clean) {
  return vertexNormals(clean.mesh).row(0).dot(clean.mesh.vertices.row(0)) > 0;
}

TEST(CleanSides, takesAMeshThatDoesNotTellForInsideOutWhereTheOtherOneIs) {
  for (bool source_is_half : {false, true}) {
    SideSurface source(ball(source_is_half, true)), target(ball(!source_is_half, true));
    const CleanSides clean = cleanSides(source, target);
    EXPECT_TRUE(looksOutward(clean.source));
    EXPECT_TRUE(looksOutward(clean.target));
  }
}

TEST(CleanSides, leavesAMeshThatDoesNotTellWhereTheOtherOneLooksOutward) {
  for (bool inside_out : {false, true}) {
    SideSurface source(ball(true, inside_out)), target(ball(false, false));
    EXPECT_EQ(looksOutward(cleanSides(source, target).source), !inside_out);
  }
}

TEST(CleanSides, leavesTwoThatDoNotTellAsTheyAre) {
  SideSurface source(ball(true, true)), target(ball(true, false));
  const CleanSides clean = cleanSides(source, target);
  EXPECT_FALSE(looksOutward(clean.source));
  EXPECT_TRUE(looksOutward(clean.target));
}

TEST(CleanSides, doesNotTurnAMeshForTheSurfaceOfACloud) {
  SideSurface source(ball(true, false)), target(ball(false, true));
  source.scan.emplace();
  EXPECT_TRUE(looksOutward(cleanSides(source, target).source));
}

TEST(CleanSides, namesTheSideThatCannotBeMeasured) {
  SideSurface good(ball(false, false)), large = good;
  large.mesh.vertices *= 1e100;
  const std::string why = " has coordinates too large to compute with";
  EXPECT_EQ(test::inputErrorOf([&] { cleanSides(large, good); }), "source" + why);
  EXPECT_EQ(test::inputErrorOf([&] { cleanSides(good, large); }), "target" + why);
}

}  // namespace
}  // namespace posture
