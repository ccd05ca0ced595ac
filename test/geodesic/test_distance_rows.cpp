// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/geodesic/distance_rows.h>
#include <posture/geodesic/fast_marching.h>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

TEST(DistanceRows, areThoseOfTheMarch) {
  const TriangleMesh mesh = test::sphere(2);
  const DistanceRows rows(mesh);
  const FastMarching marching(mesh);
  GeodesicField field;
  for (int source : {3, 0, 40, 3}) {
    marching.march(source, field);
    EXPECT_EQ(rows.from(source), field.distance);
  }
}

TEST(DistanceRows, areKept) {
  const DistanceRows rows(test::sphere(1));
  const std::vector<double>* const first = &rows.from(5);
  rows.from(6);
  EXPECT_EQ(&rows.from(5), first);
}

TEST(DistanceRows, areTheSameForAllThreads) {
  const TriangleMesh mesh = test::sphere(2);
  const DistanceRows rows(mesh), alone(mesh);
  std::vector<std::vector<double>> found(200);
  parallelFor(200, [&](int i) { found[i] = rows.from(i / 20); });
  for (int i = 0; i < 200; ++i) EXPECT_EQ(found[i], alone.from(i / 20));
}

TEST(DistanceRows, refuseVerticesThatAreNone) {
  const DistanceRows rows(test::sphere(0));
  EXPECT_THROW(rows.from(-1), std::invalid_argument);
  EXPECT_THROW(rows.from(1000), std::invalid_argument);
}

}  // namespace
}  // namespace posture
