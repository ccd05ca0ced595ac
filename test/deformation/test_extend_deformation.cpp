// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/extend_deformation.h>
#include <posture/mesh/edges.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

/// An ellipsoid, moved.
struct Moved {
  Moved() : rest(test::sphere(4)) {
    rest.vertices.col(0) *= 2;
    rest.vertices.col(1) *= 1.4;
    const Eigen::Isometry3d motion = Eigen::Translation3d(4, 1, -2) *
                                     Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, -1).normalized());
    places = (motion * rest.vertices.transpose()).transpose();
  }

  std::vector<char> beyond(double x) const {
    std::vector<char> marked(rest.vertices.rows());
    for (std::size_t v = 0; v < marked.size(); ++v)
      marked[v] = rest.vertices(static_cast<Eigen::Index>(v), 0) > x ? 1 : 0;
    return marked;
  }

  TriangleMesh rest;
  Points places;
};

TEST(ExtendDeformation, laysACapAsTheRestGoes) {
  const Moved body;
  const std::vector<char> cap = body.beyond(1);
  Points start = body.places;
  for (std::size_t v = 0; v < cap.size(); ++v)
    if (cap[v] != 0) start.row(static_cast<Eigen::Index>(v)) = body.places.row(0);
  const double edge = meanEdgeLength(body.rest);
  const Points laid = extendDeformation(body.rest, start, cap);
  EXPECT_LT((laid - body.places).rowwise().norm().maxCoeff(), 0.1 * edge);
  for (std::size_t v = 0; v < cap.size(); ++v)
    if (cap[v] == 0) {
      const auto row = static_cast<Eigen::Index>(v);
      EXPECT_EQ(laid.row(row), start.row(row));
    }
}

TEST(ExtendDeformation, leavesWhatNothingHolds) {
  const Moved body;
  EXPECT_EQ(extendDeformation(body.rest, body.places, body.beyond(-10)), body.places);
  EXPECT_EQ(extendDeformation(body.rest, body.places, body.beyond(10)), body.places);
}

TEST(ExtendDeformation, refusesWhatDoesNotFit) {
  const Moved body;
  EXPECT_THROW(extendDeformation(body.rest, body.places.topRows(3), body.beyond(1)),
               std::invalid_argument);
  EXPECT_THROW(extendDeformation(body.rest, body.places, {1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace posture
