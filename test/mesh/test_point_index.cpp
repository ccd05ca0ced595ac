// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/mesh/point_index.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace posture {
namespace {

Points randomPoints(int count, Rng& rng) {
  Points points(count, 3);
  for (int i = 0; i < points.size(); ++i) points.data()[i] = rng.uniform();
  return points;
}

TEST(PointIndex, findsWhatExhaustiveSearchFinds) {
  Rng rng(1);
  const Points points = randomPoints(500, rng), queries = randomPoints(200, rng);
  const PointIndex index(points);
  for (int q = 0; q < queries.rows(); ++q) {
    const auto found = index.nearest(queries.row(q));
    const double least = (points.rowwise() - queries.row(q)).rowwise().norm().minCoeff();
    EXPECT_NEAR(found.distance, least, 1e-6);
    EXPECT_NEAR((points.row(found.index) - queries.row(q)).norm(), least, 1e-6);
  }
}

TEST(PointIndex, isAsGoodFarFromTheOrigin) {
  Rng rng(2);
  Points points = randomPoints(500, rng);
  const Eigen::RowVector3d far(5e5, 4e6, 300);  // a map's coordinates, in metres
  points.rowwise() += far;
  const PointIndex index(points);
  for (int i = 0; i < points.rows(); ++i) EXPECT_EQ(index.nearest(points.row(i)).index, i);
}

TEST(PointIndex, takesAnyUnit) {
  Rng rng(3);
  const Points points = randomPoints(500, rng);
  for (const double unit : {1e-30, 1e30}) {
    const PointIndex index(unit * points);
    for (int i = 0; i < points.rows(); ++i) {
      const auto found = index.nearest(unit * points.row(i));
      EXPECT_EQ(found.index, i);
      EXPECT_LT(found.distance, 1e-6 * unit);
    }
  }
}

TEST(PointIndex, findsAllWithinARadiusInAnyFrame) {
  Rng rng(5);
  const Points around_origin = randomPoints(500, rng), queries = randomPoints(50, rng);
  const Eigen::RowVector3d far(5e5, 4e6, 300);
  const Points points = (100 * around_origin).rowwise() + far;
  const PointIndex index(points);
  for (int q = 0; q < queries.rows(); ++q) {
    // Outside of the points as well.
    const Eigen::RowVector3d query = 3 * (100 * queries.row(q)) + far;
    for (double radius : {0.5, 20.0, 150.0}) {
      std::vector<int> found = index.within(query, radius), all;
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      const auto isWithin = [&](int v) { return (points.row(v) - query).norm() < radius; };
      found.erase(std::remove_if(found.begin(), found.end(), std::not_fn(isWithin)), found.end());
      for (int v = 0; v < points.rows(); ++v)
        if (isWithin(v)) all.push_back(v);
      EXPECT_EQ(found, all);
    }
  }
}

TEST(PointIndex, findsSeveralNearOnesFirst) {
  Rng rng(4);
  const Points points = randomPoints(300, rng);
  const PointIndex index(points);
  const Eigen::Vector3d query = points.row(17);
  std::vector<double> distances;
  for (int i = 0; i < points.rows(); ++i)
    distances.push_back((points.row(i).transpose() - query).norm());
  std::sort(distances.begin(), distances.end());
  const auto found = index.nearest(query, 12);
  ASSERT_EQ(found.size(), 12u);
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k].distance, distances[k], 1e-6);
  EXPECT_EQ(found.front().index, 17);
  EXPECT_EQ(index.nearest(query, 1000).size(), 300u);
}

TEST(PointIndex, answersWhatIsOutOfTheReachOfSinglePrecision) {
  Points points(3, 3);
  points << 0, 0, 0, 2, 0, 0, 0, 0, 1;
  const PointIndex index(points);
  for (const double far : {1e6, 1e20, 1e60, 1e300}) {
    const PointIndex::Neighbor nearest = index.nearest({far, 0, -0.1 * far});
    EXPECT_EQ(nearest.index, 1) << far;  // of the three the one on that side
    EXPECT_NEAR(nearest.distance / far, std::sqrt(1.01), 5e-3);
    EXPECT_EQ(index.within({far, 0, 0}, 2 * far).size(), 3u);
    EXPECT_TRUE(index.within({far, 0, 0}, 0.5 * far).empty());
  }
}

TEST(PointIndex, refusesNoPoints) { EXPECT_THROW(PointIndex(Points(0, 3)), std::invalid_argument); }

TEST(PointIndex, refusesWhatIsNotFinite) {
  Points points = Points::Identity(3, 3);
  const PointIndex index(points);
  for (const double not_finite : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(index.nearest({0, not_finite, 0}), std::invalid_argument);
    EXPECT_THROW(index.within({0, 0, not_finite}, 1), std::invalid_argument);
    points(1, 1) = not_finite;
    EXPECT_THROW(PointIndex{points}, std::invalid_argument);
  }
}

}  // namespace
}  // namespace posture
