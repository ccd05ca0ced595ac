// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/synthesis/depth_camera.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>
#include <omp.h>
#include <set>

namespace posture {
namespace {

using test::grid;

/// A plate of 2 x 2 at this depth before a camera that looks along +z.
TriangleMesh plate(double depth, double slope = 0) {
  TriangleMesh mesh = grid(1, 1, 2, 2);
  mesh.vertices.rowwise() += Eigen::RowVector3d(-1, -1, depth);
  mesh.vertices.col(2) += slope * mesh.vertices.col(0);
  return mesh;
}

DepthCamera camera(int size = 60, double focal = 60) {
  DepthCamera camera;
  camera.width = camera.height = size;
  camera.focal = focal;
  return camera;
}

/// `zoom` 1: an image as wide as it is far away.
DepthImage take(const TriangleMesh& mesh,
                const DepthDefects& defects,
                int size = 60,
                double zoom = 1) {
  return takeDepthImage(RayCaster(mesh), mesh, camera(size, zoom * size), defects, 7);
}

TEST(DepthCamera, withoutDefectsMeasuresTheDepth) {
  const DepthImage image = take(plate(3, 0.5), {});
  const DepthCamera view = camera();
  int seen = 0;
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 60; ++column) {
      const Eigen::Index pixel = Eigen::Index{row} * 60 + column;
      const Eigen::Vector3d ray = view.ray(column, row);
      const double depth = 3 / (1 - 0.5 * ray.x());  // z = 3 + x / 2 on the plate
      const bool meets = std::abs(depth * ray.x()) <= 1 && std::abs(depth * ray.y()) <= 1;
      ASSERT_EQ(std::isfinite(image.depth[pixel]), meets) << column << ' ' << row;
      ASSERT_EQ(image.hit[static_cast<std::size_t>(pixel)].face >= 0, meets);
      if (!meets) continue;
      ++seen;
      ASSERT_NEAR(image.depth[pixel], depth, 1e-12);
    }
  EXPECT_GT(seen, 1000);
}

TEST(DepthCamera, noiseAndStepsGrowWithTheSquareOfTheDepth) {
  DepthDefects defects;
  defects.noise = 0.002;
  defects.reference_depth = 1;
  for (const double depth : {1.0, 2.0}) {
    const Vector error = take(plate(depth), defects, 100, 10).depth.array() - depth;
    double sum = 0, count = 0;
    for (const double e : error)
      if (std::isfinite(e)) sum += e * e, ++count;
    EXPECT_NEAR(std::sqrt(sum / count) / (0.002 * depth * depth), 1, 0.06);
  }
  defects.noise = 0;
  defects.step = 0.01;
  for (const double depth : {1.0, 2.0}) {
    std::set<double> levels;
    for (const double z : take(plate(depth, 0.1), defects, 100).depth)
      if (std::isfinite(z)) levels.insert(z);
    ASSERT_GT(levels.size(), 4u);
    auto at = levels.lower_bound(depth);
    const double low = *std::prev(at);
    EXPECT_NEAR((*at - low) / (0.01 * depth * depth), 1, 0.05);
  }
}

TEST(DepthCamera, losesWhatIsSeenAslant) {
  DepthDefects defects;
  defects.lost_aslant = 0.2;
  // The cosine of the incidence in the middle of the image is 1 / sqrt(1 + slope^2).
  const auto returns = [&](double cosine) {
    TriangleMesh mesh = plate(3, std::sqrt(1 / (cosine * cosine) - 1));
    mesh.vertices.leftCols(2) *= 0.1;
    mesh.vertices.col(2).array() = 3 + (mesh.vertices.col(2).array() - 3) * 0.1;
    return take(mesh, defects, 400).depth.array().isFinite().count();
  };
  EXPECT_GT(returns(0.5), 400);
  EXPECT_EQ(returns(0.15), 0);
}

TEST(DepthCamera, measuresBetweenTheDepthsAtSilhouettesOnly) {
  DepthDefects defects;
  defects.flying = 1;
  defects.depth_edge = 0.1;
  TriangleMesh mesh = plate(2);
  mesh.vertices.leftCols(2) *= 0.4;
  const DepthImage image = take(test::joined(mesh, plate(3)), defects);
  int between = 0;
  for (Eigen::Index pixel = 0; pixel < image.depth.size(); ++pixel) {
    const double depth = image.depth[pixel];
    if (!std::isfinite(depth)) continue;
    EXPECT_GE(depth, 2 - 1e-12);
    const bool shows_surface = image.hit[static_cast<std::size_t>(pixel)].face >= 0;
    EXPECT_EQ(shows_surface, std::abs(depth - 2) < 1e-12 || std::abs(depth - 3) < 1e-12);
    between += depth > 2.001 && depth < 2.999;
  }
  // The near plate is 24 pixels wide: as many at each of its four sides.
  EXPECT_NEAR(between, 4 * 24 - 4, 6);
}

TEST(DepthCamera, outliersAreAsManyAsAskedAndSayNothing) {
  DepthDefects defects;
  defects.outliers = 0.1;
  const DepthImage image = take(plate(1), defects, 200);
  const double pixels = 200 * 200;
  double wrong = 0;
  for (std::size_t pixel = 0; pixel < image.hit.size(); ++pixel) wrong += image.hit[pixel].face < 0;
  EXPECT_NEAR(wrong / pixels, 0.1, 0.01);
}

TEST(DepthCamera, isTheSameForAnyNumberOfThreads) {
  DepthDefects defects;
  defects.noise = defects.step = defects.outliers = 0.01;
  defects.jitter = 0.5;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const DepthImage one = take(plate(2, 0.3), defects);
  omp_set_num_threads(4);
  const DepthImage four = take(plate(2, 0.3), defects);
  omp_set_num_threads(before);
  for (Eigen::Index pixel = 0; pixel < one.depth.size(); ++pixel)
    ASSERT_TRUE(one.depth[pixel] == four.depth[pixel] ||
                (std::isnan(one.depth[pixel]) && std::isnan(four.depth[pixel])));
}

}  // namespace
}  // namespace posture
