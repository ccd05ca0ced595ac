// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "doubts.h"
#include "support/shapes.h"

namespace posture {
namespace {

/// Two sheets of 20 x 20 quads of side `edge` that look away from each other.
TriangleMesh sheets(double edge, double gap) {
  const TriangleMesh sheet = test::grid(20, 20, 20 * edge, 20 * edge);
  const auto n = sheet.vertices.rows(), m = sheet.faces.rows();
  TriangleMesh both{Points(2 * n, 3), Faces(2 * m, 3)};
  both.vertices << sheet.vertices, sheet.vertices;
  both.vertices.bottomRows(n).col(2).array() -= gap;
  both.faces << sheet.faces, sheet.faces.rowwise().reverse().array() + static_cast<int>(n);
  return both;
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

}  // namespace
}  // namespace posture
