// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/corners.h>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

TEST(CornerPlaces, countsAPlaceOnceHoweverOftenTheFileHasIt) {
  const TriangleMesh sphere = test::sphere(1);
  const int n = static_cast<int>(sphere.vertices.rows());
  TriangleMesh soup{Points(3 * sphere.faces.rows(), 3), Faces(sphere.faces.rows(), 3)};
  for (int i = 0; i < soup.vertices.rows(); ++i) {
    soup.vertices.row(i) = sphere.vertices.row(sphere.faces(i / 3, i % 3));
    soup.faces(i / 3, i % 3) = i;
  }
  EXPECT_EQ(cornerPlaces(sphere, n), n);
  EXPECT_EQ(cornerPlaces(soup, static_cast<int>(soup.vertices.rows())), n);
  TriangleMesh more = sphere;  // a point in no face, and a patch's vertex
  more.vertices.conservativeResize(n + 2, 3);
  more.vertices.bottomRows(2) << 5, 5, 5, 6, 6, 6;
  more.faces(0, 0) = n + 1;
  EXPECT_EQ(cornerPlaces(more, n + 1), n);
  more.faces.row(1).setConstant(n);  // no face any more
  EXPECT_EQ(cornerPlaces(more, n + 1), n);
}

}  // namespace
}  // namespace posture
