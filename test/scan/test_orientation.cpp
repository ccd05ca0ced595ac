// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "points/orientation.h"
#include "scan_shapes.h"

namespace posture {
namespace {

/// True normals of a torus with signs left to chance.
Points scrambled(Points normals, std::uint64_t seed) {
  Rng rng(seed);
  for (int i = 0; i < normals.rows(); ++i)
    if (rng.below(2) == 0) normals.row(i) *= -1;
  return normals;
}

Points torusNormals(const Points& points, double large) {
  Points normals = points;
  for (int i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d ring(points(i, 0), points(i, 1), 0);
    normals.row(i) = (points.row(i) - large * ring.normalized()).normalized();
  }
  return normals;
}

int agreeing(const Points& a, const Points& b) {
  return static_cast<int>(((a.array() * b.array()).rowwise().sum() > 0).count());
}

OrientationSummary orient(const Points& points, const OutsideHints& hints, Points& normals) {
  const NeighborTable neighbors = NeighborSearch(points).table(32);
  return orientNormals(points, neighbors, spacing(points, neighbors), hints, normals);
}

TEST(Orientation, looksOutOfATorusAlsoInItsHole) {
  const Points points = test::torusPoints(4000, 1, 0.3), truth = torusNormals(points, 1);
  Points normals = scrambled(truth, 1);
  orient(points, {}, normals);
  EXPECT_EQ(agreeing(normals, truth), 4000);
}

TEST(Orientation, isToldByNoPointAtTheSamePlace) {
  const Points once = test::torusPoints(2000, 1, 0.3), points = test::joined(once, once);
  const Points truth = torusNormals(points, 1);
  Points normals = scrambled(truth, 1);
  orient(points, {}, normals);
  EXPECT_EQ(agreeing(normals, truth), 4000);
}

TEST(Orientation, ofAClosedBodyDoesNotBelieveNormalsThatLookInwards) {
  const Points points = test::torusPoints(4000, 1, 0.3), truth = torusNormals(points, 1);
  Points normals = scrambled(truth, 1);
  const OrientationSummary summary = orient(points, {-truth, HintSource::NORMALS}, normals);
  EXPECT_FALSE(summary.by_normals);
  EXPECT_EQ(agreeing(normals, truth), 4000);
}

TEST(Orientation, ofAnOpenSurfaceFollowsConsistentNormals) {
  const Points points = test::planePoints(2000, 0);
  Points up = Points::Zero(2000, 3);
  up.col(2).setOnes();
  for (const double side : {1.0, -1.0}) {
    Points normals = scrambled(up, 3);
    EXPECT_TRUE(orient(points, {side * up, HintSource::NORMALS}, normals).by_normals);
    EXPECT_EQ(agreeing(normals, side * up), 2000);
  }
}

TEST(Orientation, ignoresNormalsWithoutConsistentSign) {
  const Points points = test::planePoints(2000, 0);
  Points up = Points::Zero(2000, 3);
  up.col(2).setOnes();
  Points normals = scrambled(up, 3);
  EXPECT_FALSE(orient(points, {scrambled(up, 4), HintSource::NORMALS}, normals).by_normals);
  const int agree = agreeing(normals, up);
  EXPECT_TRUE(agree == 0 || agree == 2000);
}

TEST(Orientation, looksAtTheSensorEvenFromInside) {
  const Points points = test::spherePoints(4000, 0);
  Points normals = scrambled(points, 2);
  const OutsideHints hints{-points, HintSource::SENSOR};  // the scanner stands in the middle
  EXPECT_TRUE(orient(points, hints, normals).by_sensor);
  EXPECT_EQ(agreeing(normals, -points), 4000);
}

TEST(Orientation, doesNotBelieveASensorThatSawOneSideOfABodyOnly) {
  const Points points = test::torusPoints(4000, 1, 0.3), truth = torusNormals(points, 1);
  for (const Eigen::RowVector3d& sensor :
       {Eigen::RowVector3d(4, 0, 0), Eigen::RowVector3d(0, 2.5, 0), Eigen::RowVector3d(1, 2, 9)}) {
    Points normals = scrambled(truth, 5);
    const Points directions = ((-points).rowwise() + sensor).rowwise().normalized();
    EXPECT_FALSE(orient(points, {directions, HintSource::SENSOR, sensor}, normals).by_sensor);
    EXPECT_EQ(agreeing(normals, truth), 4000);
  }
}

TEST(Orientation, doesNotBelieveASensorNearAThickBodyThatIsClosed) {
  const Points points = test::spherePoints(8000, 0);
  for (const double away : {1.2, 1.5, 2.0, 4.0}) {
    SCOPED_TRACE(away);
    const Eigen::RowVector3d sensor(0, 0, away);
    const Points directions = ((-points).rowwise() + sensor).rowwise().normalized();
    Points normals = scrambled(points, 7);
    EXPECT_FALSE(orient(points, {directions, HintSource::SENSOR, sensor}, normals).by_sensor);
    EXPECT_EQ(agreeing(normals, points), 8000);
  }
}

TEST(Orientation, goesByNormalsWhereASensorDidNotSeeThePoints) {
  const Points sphere = test::spherePoints(8000, 0);
  std::vector<int> upper;
  for (int i = 0; i < sphere.rows(); ++i)
    if (sphere(i, 2) > 0) upper.push_back(i);
  const Points bowl = sphere(upper, Eigen::all);
  const Eigen::RowVector3d beside(5, 0, 0);
  const Points directions = ((-bowl).rowwise() + beside).rowwise().normalized();
  for (const double side : {1.0, -1.0}) {
    Points normals = scrambled(bowl, 6);
    const OrientationSummary summary =
        orient(bowl, {directions, HintSource::SENSOR, beside, false, side * bowl}, normals);
    EXPECT_FALSE(summary.by_sensor);
    EXPECT_TRUE(summary.by_normals);
    EXPECT_EQ(agreeing(normals, side * bowl), bowl.rows());
  }
}

}  // namespace
}  // namespace posture
