// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/normals.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include "surface/doubts.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

/// Two sheets of 20 x 20 quads of side `edge` that look away from each other.
TriangleMesh sheets(double edge, double gap) {
  const TriangleMesh sheet = test::grid(20, 20, 20 * edge, 20 * edge);
  const TriangleMesh turned{sheet.vertices, sheet.faces.rowwise().reverse()};
  return test::joined(sheet, test::shifted(turned, {0, 0, -gap}));
}

TEST(ThinShare, isThatOfPartsThinnerThanThreeSpacings) {
  EXPECT_EQ(thinShare(sheets(1, 2), 1), 1);
  EXPECT_EQ(thinShare(sheets(1, 4), 1), 0);
}

TEST(ThinShare, isMeasuredInTheSpacingOfThePart) {
  // Both sides show where they are dense, whatever the spacing of the rest.
  EXPECT_EQ(thinShare(sheets(0.1, 1), 1), 0);
  EXPECT_EQ(thinShare(sheets(0.1, 0.2), 1), 1);
}

/// A sheet of 40 x 40 unit quads with a furrow along its middle, whose walls are `steep` (negative:
/// a ridge), of a width to either side that goes down to nothing at its ends.
TriangleMesh furrow(double half_length, double width, double steep) {
  TriangleMesh mesh = test::grid(40, 40, 40, 40);
  for (auto p : mesh.vertices.rowwise()) {
    const double along = std::abs(p.y() - 20), across = std::abs(p.x() - 20);
    const double here = std::clamp(0.5 * (half_length - along), 0.0, width);
    p.z() = -steep * std::max(0.0, here - across);
  }
  return mesh;
}

int contacts(const TriangleMesh& mesh) { return possibleContacts(mesh, vertexNormals(mesh), 1); }

TEST(PossibleContacts, areSharpValleysWithoutAShortWayAround) {
  EXPECT_EQ(contacts(furrow(1000, 20, 0.7)), 1) << "from edge to edge: there is no way around";
  EXPECT_EQ(contacts(furrow(6, 2, 0.7)), 0) << "its walls meet where it ends";
  EXPECT_EQ(contacts(furrow(1000, 20, 0.2)), 0) << "shallow";
  EXPECT_EQ(contacts(furrow(1000, 20, -0.7)), 0) << "a ridge";
  EXPECT_EQ(contacts(furrow(0, 0, 1)), 0) << "flat";
}

TEST(PossibleContacts, areCountedPlaceByPlace) {
  const TriangleMesh one = furrow(1000, 20, 0.7);
  EXPECT_EQ(contacts(test::joined(one, test::shifted(one, {100, 0, 0}))), 2);
}

}  // namespace
}  // namespace posture
