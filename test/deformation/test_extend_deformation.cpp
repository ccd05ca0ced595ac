// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/extend_deformation.h>
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "support/motions.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// An ellipsoid, moved.
struct Moved {
  Moved() : rest(test::sphere(4)) {
    rest.vertices.col(0) *= 2;
    rest.vertices.col(1) *= 1.4;
    places = test::moved(rest.vertices, test::motion(1.2));
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

TEST(ExtendDeformation, bendsEvenlyBetweenEnds) {
  const TriangleMesh rest = test::grid(40, 12, 4, 1), bent = test::bentStrip(40, 12, 4, 1, 2);
  std::vector<char> middle(rest.vertices.rows());
  for (std::size_t v = 0; v < middle.size(); ++v)
    middle[v] = std::abs(rest.vertices(static_cast<Eigen::Index>(v), 0) - 2) < 0.8 ? 1 : 0;
  const Points laid = extendDeformation(rest, bent.vertices, middle);
  double stretch = 0;
  for (const Edge& e : meshEdges(rest.faces))
    stretch =
        std::max(stretch,
                 std::abs((laid.row(e.first) - laid.row(e.second)).norm() /
                              (rest.vertices.row(e.first) - rest.vertices.row(e.second)).norm() -
                          1));
  EXPECT_LT(stretch, 0.1);
  EXPECT_LT((laid - bent.vertices).rowwise().norm().maxCoeff(), meanEdgeLength(rest));

  // The same in any unit.
  constexpr double UNIT = 1 << 24;
  const Points in_other_unit =
      extendDeformation({UNIT * rest.vertices, rest.faces}, UNIT * bent.vertices, middle);
  EXPECT_LT((in_other_unit / UNIT - laid).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ExtendDeformation, laysEachRegionByTheSurfaceAroundIt) {
  // Ends that nearly meet at rest lie far from each other when the ring is unrolled.
  const TriangleMesh rest = test::bentStrip(80, 12, 6, 0.9, 6.1), flat = test::grid(80, 12, 6, 0.9);
  std::vector<char> holes(rest.vertices.rows());
  for (std::size_t v = 0; v < holes.size(); ++v) {
    const auto at = flat.vertices.row(static_cast<Eigen::Index>(v));
    for (double x : {0.35, 5.65})
      if (std::hypot(at.x() - x, at.y() - 0.45) < 0.25) holes[v] = 1;
  }
  const Points laid = extendDeformation(rest, flat.vertices, holes);
  EXPECT_LT((laid - flat.vertices).rowwise().norm().maxCoeff(), meanEdgeLength(rest));
}

TEST(ExtendDeformation, leavesWhatNothingHoldsAndWhatIsKnown) {
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
