// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "points/outside_hints.h"

#include <posture/core/median.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace posture {
namespace {

Eigen::RowVector3d unitOrZero(const Eigen::RowVector3d& v) {
  const double length = v.stableNorm();
  return length > 0 && std::isfinite(length) ? Eigen::RowVector3d(v / length)
                                             : Eigen::RowVector3d(0, 0, 0);
}

/// Difference of two cells of the grid, of which `cell` itself may be one; zero at missing points.
Eigen::RowVector3d difference(const Points& points, int before, int cell, int after) {
  const auto seen = [&](int c) { return c >= 0 && points.row(c).allFinite(); };
  const int from = seen(before) ? before : cell, to = seen(after) ? after : cell;
  return points.row(to) - points.row(from);
}

/// Towards the eye: columns run right and rows down, so that right x down looks away from it.
Eigen::RowVector3d towardsEye(const PointCloud& cloud, int cell) {
  const int n = static_cast<int>(cloud.points.rows()), width = cloud.width;
  const int column = cell % width;
  const Eigen::RowVector3d right = difference(cloud.points,
                                              column > 0 ? cell - 1 : -1,
                                              cell,
                                              column + 1 < width && cell + 1 < n ? cell + 1 : -1);
  const Eigen::RowVector3d down =
      difference(cloud.points, cell - width, cell, cell + width < n ? cell + width : -1);
  return unitOrZero(unitOrZero(down).cross(unitOrZero(right)));
}

/// Whether points may have been seen from a place: not from the middle of them, nor from where they
/// are a speck, as the origin of a map is. Points that were moved often keep the place they had, or
/// the origin.
bool isOutlook(const Eigen::Vector3d& place, const Points& points, const std::vector<int>& rows) {
  // The mean direction of what fills less than half of all is longer.
  constexpr double HALF_SPACE = 0.5;
  // Within a fifth of a degree: a person at some 400 metres.
  constexpr double SPECK = 1e-6;
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const int row : rows) sum += unitOrZero(points.row(row) - place.transpose());
  const double mean = sum.norm() / static_cast<double>(rows.size());
  return mean >= HALF_SPACE && 1 - mean > SPECK;
}

/// Whether a depth image was taken from a place: its rows then lie in planes through it, to a
/// fraction of a pixel and however noisy the depths are. From where an image that was moved did not
/// stand, rows bend with the distance.
/// \param otherwise  the answer where no row is long enough to tell.
bool isEye(const Eigen::Vector3d& place, const PointCloud& image, bool otherwise) {
  constexpr std::size_t ENOUGH = 8;  // points of a row
  constexpr double FRACTION = 0.25;  // of a pixel
  const Eigen::Index width = image.width, rows = image.points.rows() / width;
  std::vector<double> bent;  // by how many pixels, a row
  for (Eigen::Index row = 0; row < rows; ++row) {
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    std::vector<double> steps;
    Eigen::RowVector3d before = Eigen::RowVector3d::Zero();
    std::size_t seen = 0;
    for (Eigen::Index cell = row * width; cell < (row + 1) * width; ++cell) {
      const Eigen::RowVector3d way = image.points.row(cell).allFinite()
                                         ? unitOrZero(image.points.row(cell) - place.transpose())
                                         : Eigen::RowVector3d::Zero();
      if (!way.isZero()) {
        moments += way.transpose() * way;
        ++seen;
        if (!before.isZero()) steps.push_back((way - before).norm());
      }
      before = way;
    }
    if (steps.size() < ENOUGH) continue;
    const double step = median(std::move(steps));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
    const double off =
        std::sqrt(std::max(0.0, solver.eigenvalues()[0]) / static_cast<double>(seen));
    if (step > 0) bent.push_back(off / step);
  }
  return bent.empty() ? otherwise : median(std::move(bent)) < FRACTION;
}

/// Whether points are where a camera at the origin looks, as in files and messages that nobody
/// moved: along the z of its frame (optical frames) or the x, and hardly any right before the lens
/// or in it, where missing points are put.
bool areAhead(const Points& points, const std::vector<int>& rows) {
  constexpr double MOSTLY = 0.7;  // cosine
  constexpr double CLOSE = 0.1;   // of the median distance
  constexpr double FEW = 0.01;    // of the points
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  std::vector<double> distances;
  for (const int row : rows) {
    sum += unitOrZero(points.row(row));
    distances.push_back(points.row(row).stableNorm());
  }
  if (std::max(sum.x(), sum.z()) < MOSTLY * static_cast<double>(rows.size())) return false;
  const double close = CLOSE * median(distances);
  const auto num_close = std::count_if(
      distances.begin(), distances.end(), [&](double distance) { return distance <= close; });
  return static_cast<double>(num_close) <= std::max(1.0, FEW * static_cast<double>(rows.size()));
}

/// Where a scanner may have stood: where the cloud says, or, where it says nothing that is surer,
/// at the origin.
std::optional<Eigen::Vector3d> sensorOf(const PointCloud& cloud,
                                        const std::vector<int>& rows,
                                        bool is_image) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  if (cloud.sensor)
    place = *cloud.sensor;
  else if (!is_image && (cloud.normals.rows() > 0 || !areAhead(cloud.points, rows)))
    return std::nullopt;
  if (!place.allFinite() || !isOutlook(place, cloud.points, rows)) return std::nullopt;
  if (is_image && !isEye(place, cloud, cloud.sensor.has_value())) return std::nullopt;
  return place;
}

}  // namespace

OutsideHints outsideHints(const PointCloud& cloud, const std::vector<int>& rows) {
  OutsideHints hints;
  const bool is_image = cloud.width > 1 && cloud.points.rows() > cloud.width;
  const auto forEachRow = [&](auto&& direction) {
    Points directions(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t i = 0; i < rows.size(); ++i)
      directions.row(static_cast<Eigen::Index>(i)) = direction(rows[i]);
    return directions;
  };
  if (cloud.normals.rows() > 0)
    hints.normals = forEachRow([&](int row) { return unitOrZero(cloud.normals.row(row)); });
  if (const auto sensor = sensorOf(cloud, rows, is_image)) {
    hints.source = HintSource::SENSOR;
    hints.sensor = sensor->transpose();
    hints.is_assumed = !cloud.sensor && !is_image;  // the rows of an image tell
    hints.directions =
        forEachRow([&](int row) { return unitOrZero(hints.sensor - cloud.points.row(row)); });
  } else if (is_image) {
    hints.source = HintSource::GRID;
    hints.directions = forEachRow([&](int row) { return towardsEye(cloud, row); });
  } else {
    hints = withoutSensor(hints);
  }
  return hints;
}

}  // namespace posture
