// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/front_end.h"

#include <posture/core/error.h>

#include <Eigen/Eigenvalues>

#include "noisy/normals.h"
#include "noisy/resampling.h"
#include "noisy/smoothing.h"
#include "noisy/thinning.h"
#include "pcl/pcl_surfaces.h"
#include "points/outliers.h"
#include "points/spacing.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace posture {
namespace {

constexpr int NEIGHBORS = 32;

/// What outliers are told by.
constexpr int FEW_NEIGHBORS = 16;

/// So many show where the surface is, where there is little noise; with more of them needed, points
/// are averaged in cells, until so many are as far apart as those were.
constexpr int ENOUGH = 10;
constexpr double CELL = 0.8;  ///< side of a cell, over the distance between the means

/// Of PCL's moving least squares, in spacings.
constexpr double MLS_RADIUS = 3;

void requireBreadth(const Points& points) {
  const Points centred = points.rowwise() - points.colwise().mean();
  const Eigen::Matrix3d covariance =
      centred.transpose() * centred / static_cast<double>(points.rows());
  // Not computeDirect(), whose errors may look like breadth.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  const double breadth_sq = solver.eigenvalues()[1];
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  // Points of a line are as broad as rounding leaves them.
  constexpr double ROUNDING_SQ = 1e-12;
  if (!(breadth_sq > ROUNDING_SQ * extent * extent))
    throw InputError("has all its points on one line");
}

/// One point a cell, where the surface shows only in the mean of many.
ScanPoints averaged(const ScanPoints& scan, double side) {
  const Cells cells = averageInCells(scan.points, side);
  const auto meanDirections = [&](const Points& directions) {
    if (directions.rows() == 0) return directions;
    Points sums = Points::Zero(cells.means.rows(), 3);
    for (int i = 0; i < scan.points.rows(); ++i) sums.row(cells.cell[i]) += directions.row(i);
    for (int c = 0; c < sums.rows(); ++c) sums.row(c).normalize();  // 0, not known, stays 0
    return sums;
  };
  return {cells.means,
          {meanDirections(scan.hints.directions),
           scan.hints.source,
           scan.hints.sensor,
           scan.hints.is_assumed,
           meanDirections(scan.hints.normals)}};
}

}  // namespace

ScanPoints filterPoints(const ScanPoints& given,
                        std::vector<int>& kept,
                        ReconstructionSummary& summary) {
  const NeighborTable neighbors = NeighborSearch(given.points).table(FEW_NEIGHBORS);
  const Spacing h = spacing(given.points, neighbors);
  summary.spacing = h.median;
  const std::vector<char> keep = withoutOutliers(given.points, neighbors, h);
  for (int i = 0; i < given.points.rows(); ++i)
    if (keep[i]) kept.push_back(i);
  summary.outliers = static_cast<int>(given.points.rows()) - static_cast<int>(kept.size());
  if (kept.empty()) throw InputError("has no points close enough to each other to be a surface");
  ScanPoints scan{given.points(kept, Eigen::all), rowsOf(given.hints, kept)};
  requireBreadth(scan.points);

  const NoiseScale noise = noiseScale(scan.points, NeighborSearch(scan.points));
  summary.double_walls = noise.double_walls;
  if (noise.neighbors > ENOUGH) {
    summary.averaged = noise.neighbors;
    scan = averaged(
        scan, CELL * summary.spacing * std::sqrt(noise.neighbors / static_cast<double>(ENOUGH)));
  }
  return scan;
}

OrientedPoints sampleSurface(const ScanPoints& scan,
                             SurfaceMethod method,
                             ReconstructionSummary& summary) {
  OrientedPoints oriented{scan.points, {}};
  NeighborTable neighbors = NeighborSearch(scan.points).table(NEIGHBORS);
  const Spacing h = spacing(scan.points, neighbors);
  if (method == SurfaceMethod::MLS) {
    oriented = movingLeastSquares(scan.points, MLS_RADIUS * h.median);
    neighbors = NeighborSearch(oriented.points).table(NEIGHBORS);
  }
  EstimatedNormals estimated = estimateNormals(scan.points, neighbors, h);
  summary.noise = estimated.residual;
  if (method != SurfaceMethod::MLS) oriented.normals = std::move(estimated.normals);
  const OrientationSummary orientation =
      orientNormals(oriented.points, neighbors, h, scan.hints, oriented.normals);
  summary.oriented_by_sensor = orientation.by_sensor;
  summary.oriented_by_normals = orientation.by_normals;
  if (method != SurfaceMethod::MLS) smooth(neighbors, h, estimated.relative_residual, oriented);
  return thin(oriented, neighbors, h);
}

}  // namespace posture
