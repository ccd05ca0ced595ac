// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "orient_faces.h"
#include "support/shapes.h"
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Edges that two faces run along the same way.
int edgesAgainst(const Faces& faces) {
  std::map<std::pair<int, int>, int> runs;
  for (const auto& face : faces.rowwise())
    for (int k = 0; k < 3; ++k) ++runs[{face[k], face[(k + 1) % 3]}];
  int against = 0;
  for (const auto& run : runs) against += run.second > 1;
  return against;
}

TEST(OrientFaces, aClosedMeshWithFacesFlippedComesOutAlike) {
  const TriangleMesh sphere = test::sphere(2);
  for (const Facing facing : {Facing::OUTWARD, Facing::AS_MOST}) {
    TriangleMesh mesh = sphere;
    std::vector<char> flipped(mesh.faces.rows(), 0);
    for (int f = 0; f < mesh.faces.rows(); ++f) {
      if (f % 3 != 0) continue;
      flipped[f] = 1;
      std::swap(mesh.faces(f, 1), mesh.faces(f, 2));
    }
    ASSERT_GT(edgesAgainst(mesh.faces), 0);
    const Orientation orientation = orientFaces(mesh, facing);
    EXPECT_EQ(mesh.faces, sphere.faces);
    EXPECT_EQ(orientation.turned, flipped);
    EXPECT_TRUE(orientation.outward_known);
    EXPECT_FALSE(orientation.inside_out);
  }
}

TEST(OrientFaces, aMoebiusBandHasNoOutsideAndOneSeam) {
  constexpr int AROUND = 40;
  TriangleMesh band{Points(2 * AROUND, 3), Faces(2 * AROUND, 3)};
  for (int i = 0; i < AROUND; ++i) {
    const double angle = 2 * M_PI * i / AROUND;
    for (int side = 0; side < 2; ++side) {
      const double off = side == 0 ? -0.3 : 0.3, r = 1 + off * std::cos(angle / 2);
      band.vertices.row(2 * i + side) << r * std::cos(angle), r * std::sin(angle),
          off * std::sin(angle / 2);
    }
    // Behind the last come the first two, exchanged.
    const int a = 2 * i, b = 2 * i + 1, c = i + 1 < AROUND ? a + 2 : 1,
              d = i + 1 < AROUND ? b + 2 : 0;
    band.faces.row(2 * i) << a, c, b;
    band.faces.row(2 * i + 1) << b, c, d;
    if (i % 5 == 0) std::swap(band.faces(2 * i, 0), band.faces(2 * i, 1));
  }
  ASSERT_GT(edgesAgainst(band.faces), 1);
  const Orientation orientation = orientFaces(band, Facing::OUTWARD);
  EXPECT_EQ(edgesAgainst(band.faces), 1);
  EXPECT_FALSE(orientation.outward_known);
  EXPECT_FALSE(orientation.inside_out);
}

}  // namespace
}  // namespace posture
