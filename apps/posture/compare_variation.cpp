// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_variation.h"

#include <posture/core/error.h>
#include <posture/core/rng.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <utility>

namespace posture::app {
namespace {

using Eigen::Vector3d;

constexpr double TURN = 2;  // radians, about 115 degrees
constexpr double SCALE = 1000;
constexpr std::uint64_t SHUFFLE_SEED = 1;

/// Nothing about them is special: no axis of a body, no symmetry.
const Vector3d TURN_AXIS = Vector3d(1, 2, 3).normalized();
const Vector3d SHIFT(0.3, -0.2, 0.1);  // in diagonals of the box

/// About the middle of the box, then away.
Eigen::Isometry3d generalMotion(const Points& points) {
  Vector3d low = Vector3d::Constant(HUGE_VAL), high = -low;
  for (int i = 0; i < points.rows(); ++i)
    if (points.row(i).allFinite()) {
      low = low.cwiseMin(points.row(i).transpose());
      high = high.cwiseMax(points.row(i).transpose());
    }
  const Vector3d middle = (low + high) / 2;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(middle + (high - low).norm() * SHIFT);
  motion.rotate(Eigen::AngleAxisd(TURN, TURN_AXIS));
  motion.translate(-middle);
  return motion;
}

void transform(PointCloud& cloud, const Eigen::Isometry3d& motion, double scale) {
  const Eigen::Matrix3d turn = motion.linear();
  cloud.points =
      scale * ((cloud.points * turn.transpose()).rowwise() + motion.translation().transpose());
  if (cloud.normals.rows() > 0) cloud.normals = cloud.normals * turn.transpose();
  if (cloud.sensor) cloud.sensor = scale * (motion * *cloud.sensor);
}

template <class Rows>
void reorder(Rows& rows, const std::vector<int>& given) {
  if (rows.rows() == 0) return;
  const Rows before = rows;
  for (std::size_t i = 0; i < given.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = before.row(given[i]);
}

/// A grid is one no more; what is known of the sensor stays.
void shuffle(VariedShape& varied) {
  std::vector<int>& given = varied.given;
  Rng rng(SHUFFLE_SEED);
  for (int i = static_cast<int>(given.size()) - 1; i > 0; --i)
    std::swap(given[i], given[rng.below(i + 1)]);
  std::vector<int> row(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) row[given[i]] = static_cast<int>(i);
  PointCloud& cloud = varied.shape.cloud;
  reorder(cloud.points, given);
  reorder(cloud.normals, given);
  reorder(cloud.colors, given);
  cloud.width = 0;
  Faces& faces = varied.shape.faces;
  std::for_each(faces.data(), faces.data() + faces.size(), [&](int& v) { v = row[v]; });
}

}  // namespace

const std::vector<std::string>& variations() {
  static const std::vector<std::string> NAMES{"aligned", "turned", "scaled"};
  return NAMES;
}

VariedShape vary(const Shape& shape, const std::string& variation) {
  const auto& known = variations();
  require(std::find(known.begin(), known.end(), variation) != known.end(),
          "no variation '" + variation + "'");
  VariedShape varied{shape, std::vector<int>(shape.cloud.points.rows())};
  std::iota(varied.given.begin(), varied.given.end(), 0);
  if (variation == "aligned") return varied;
  const bool scaled = variation == "scaled";
  transform(varied.shape.cloud, generalMotion(shape.cloud.points), scaled ? SCALE : 1);
  if (scaled) shuffle(varied);
  return varied;
}

}  // namespace posture::app
