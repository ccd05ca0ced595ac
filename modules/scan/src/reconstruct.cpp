// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/scan/reconstruct.h>

#include "clean/clean_points.h"
#include "noisy/back_end.h"
#include "noisy/front_end.h"
#include "points/distinct_points.h"
#include "points/outside_hints.h"
#include "points/spacing.h"
#include "surface/mesh_locator.h"
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace posture {
namespace {

/// Non-zero for the rows of the cloud at a place that was kept.
std::vector<char> belongingRows(const DistinctPoints& distinct, const std::vector<int>& kept) {
  std::vector<char> belongs(distinct.place.size(), 0);
  std::vector<char> is_kept(distinct.input.size(), 0);
  for (int i : kept) is_kept[i] = 1;
  for (std::size_t row = 0; row < belongs.size(); ++row)
    if (distinct.place[row] >= 0) belongs[row] = is_kept[distinct.place[row]];
  return belongs;
}

void requireValid(const PointCloud& cloud) {
  const Eigen::Index n = cloud.points.rows();
  require(cloud.normals.rows() == 0 || cloud.normals.rows() == n,
          "reconstruct: not a normal a point");
  require(cloud.width >= 0, "reconstruct: a grid of negative width");
}

void warn(ReconstructionSummary& summary) {
  const auto say = [&](const std::string& sentence) { summary.warnings.push_back(sentence); };
  if (summary.double_walls)
    say("views do not fit each other, or the noise has no end: the surface may be doubled");
  if (summary.contacts > 0)
    say("parts that touch, or sides of a deep crease, may be joined at " +
        std::to_string(summary.contacts) + (summary.contacts == 1 ? " place" : " places"));
  // Less than this are rims and tips.
  constexpr double MANY = 0.02;
  if (summary.thin > MANY)
    say(std::to_string(std::lround(100 * summary.thin)) +
        " % of the surface belongs to parts thinner than three spacings of its vertices: their "
        "sides may be joined");
  if (summary.components > 1)
    say("the surface is in " + std::to_string(summary.components) + " pieces");
}

/// Every point of the cloud that is no outlier, on the mesh; both in the cloud's frame.
void placePoints(const PointCloud& cloud, const std::vector<char>& belongs, ScanSurface& surface) {
  const int n = static_cast<int>(cloud.points.rows());
  surface.on_mesh.resize(n);
  surface.offset = Vector::Zero(n);
  const MeshLocator locator(surface.mesh);
  forEach(n, [&](int i) {
    if (!belongs[i]) return;
    const MeshLocator::Place place = locator.nearest(cloud.points.row(i));
    surface.on_mesh[i] = place.on_mesh;
    surface.offset[i] = place.distance;
  });
}

void toCloudFrame(const ScanFrame& frame, ScanSurface& surface) {
  surface.mesh.vertices = frame.toCloud(surface.mesh.vertices);
  ReconstructionSummary& summary = surface.summary;
  for (double* length :
       {&summary.spacing, &summary.noise, &summary.mesh_spacing, &summary.boundary_length})
    *length *= frame.unit;
}

/// Smoothed, spread evenly and triangulated.
void layThroughNoise(const PointCloud& cloud,
                     const DistinctPoints& distinct,
                     const OutsideHints& hints,
                     SurfaceMethod method,
                     ScanSurface& surface) {
  std::vector<int> kept;
  const ScanPoints scan = filterPoints({distinct.points, hints}, kept, surface.summary);
  const OrientedPoints samples = sampleSurface(scan, method, surface.summary);
  surface.mesh = meshSamples(samples, method, surface.summary);
  toCloudFrame(distinct.frame, surface);
  placePoints(cloud, belongingRows(distinct, kept), surface);
}

/// Of points that are its vertices. What is farther from it than four spacings is no part of it.
void joinCleanPoints(const PointCloud& cloud,
                     const DistinctPoints& distinct,
                     PointSurface clean,
                     ScanSurface& surface) {
  surface.mesh = std::move(clean.mesh);
  toCloudFrame(distinct.frame, surface);
  for (std::size_t v = 0; v < clean.point.size(); ++v)
    if (const int i = clean.point[v]; i >= 0)
      surface.mesh.vertices.row(static_cast<Eigen::Index>(v)) = cloud.points.row(distinct.input[i]);
  std::vector<char> belongs(distinct.place.size());
  for (std::size_t row = 0; row < belongs.size(); ++row) belongs[row] = distinct.place[row] >= 0;
  placePoints(cloud, belongs, surface);
  std::vector<char> is_outlier(distinct.input.size(), 0);
  for (std::size_t row = 0; row < belongs.size(); ++row) {
    if (!(surface.offset[row] > SURFACE_REACH * surface.summary.spacing)) continue;
    is_outlier[distinct.place[row]] = 1;
    surface.on_mesh[row] = {};
    surface.offset[row] = 0;
  }
  surface.summary.outliers = static_cast<int>(std::count(is_outlier.begin(), is_outlier.end(), 1));
}

}  // namespace

ScanSurface reconstruct(const PointCloud& cloud, const ReconstructionOptions& options) {
  requireValid(cloud);
  ScanSurface surface;
  ReconstructionSummary& summary = surface.summary;
  const DistinctPoints distinct = distinctPoints(cloud.points);
  summary.points = static_cast<int>(cloud.points.rows());
  summary.missing = distinct.missing;
  summary.repeated = distinct.repeated;

  OutsideHints hints = outsideHints(cloud, distinct.input);
  hints.directions *= distinct.frame.axes;
  hints.normals *= distinct.frame.axes;
  hints.sensor = distinct.frame.toWorking(hints.sensor);
  std::optional<PointSurface> clean;
  if (options.surface == SurfaceMethod::TANGENT_DELAUNAY)
    clean = surfaceOfCleanPoints(distinct.points, hints, summary);
  if (clean)
    joinCleanPoints(cloud, distinct, std::move(*clean), surface);
  else
    layThroughNoise(cloud, distinct, hints, options.surface, surface);
  summary.outliers += distinct.far;
  warn(summary);
  return surface;
}

}  // namespace posture
