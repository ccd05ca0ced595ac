// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "target_places.h"

#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/core/median.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace posture::app {

namespace {

/// How far most of a scan's points may lie from the vertices of the surface they were taken of: the
/// vertices' spacing, and noise; and little beside the scan, where the surface is in a smaller
/// unit.
double mostApart(const Points& seen, const TriangleMesh& surface) {
  constexpr double NOISE = 0.02, LITTLE = 0.1;
  const double size = (seen.colwise().maxCoeff() - seen.colwise().minCoeff()).norm();
  return std::min(2 * meanEdgeLength(surface) + NOISE * rootArea(surface), LITTLE * size);
}

/// Errors of what does not know the file name it.
template <class Make>
auto namingFile(const std::filesystem::path& path, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace

TargetPlaces::TargetPlaces(const std::filesystem::path& path,
                           const Shape& target,
                           const std::optional<ScanSurface>& scan)
    : path_(path), itself_(target.faces.rows() > 0) {
  if (itself_) {
    mesh_ = {target.cloud.points, target.faces};
    return;
  }
  const ScanSurface laid =
      scan ? *scan : namingFile(path_, [&] { return reconstruct(target.cloud); });
  mesh_ = laid.mesh;
  for (const SurfacePoint& place : laid.on_mesh) vertex_.push_back(place.vertex);
}

TargetPlaces::TargetPlaces(const std::filesystem::path& path,
                           const Shape& target,
                           const std::filesystem::path& surface,
                           const std::filesystem::path& vertices,
                           const std::vector<VertexPair>& truth)
    : path_(surface), mesh_(readMesh(surface).mesh), vertex_(target.cloud.points.rows(), -1) {
  const bool in_one_frame = placeAtNearest(target.cloud.points, truth);
  if (!vertices.empty())
    placeByRows(vertices);
  else if (!in_one_frame)
    throw InputError(surface.string() + ": is not where " + path.string() +
                     " is: in another unit, or another frame?");
}

void TargetPlaces::placeByRows(const std::filesystem::path& vertices) {
  const auto points = static_cast<int>(vertex_.size());
  for (const VertexPair& pair : readVertexPairs(vertices)) {
    if (pair.source < 0 || pair.source >= points || pair.target < 0 ||
        pair.target >= mesh_.vertices.rows())
      throw InputError(vertices.string() + ": row `" + std::to_string(pair.source) + " " +
                       std::to_string(pair.target) + "` names what is not there");
    vertex_[pair.source] = pair.target;
  }
}

bool TargetPlaces::placeAtNearest(const Points& points, const std::vector<VertexPair>& truth) {
  const std::vector<int> seen = finiteRows(points);
  if (seen.empty()) return true;
  std::vector<char> is_true(points.rows(), 0);
  for (const VertexPair& pair : truth) is_true[pair.target] = 1;
  std::vector<int> compared;
  std::copy_if(seen.begin(), seen.end(), std::back_inserter(compared), [&](int i) {
    return is_true[i] != 0;
  });
  if (compared.empty()) compared = seen;
  const PointIndex index(mesh_.vertices);
  for (int i : seen) vertex_[i] = index.nearest(points.row(i)).index;
  std::vector<double> distances;
  distances.reserve(compared.size());
  for (int i : compared)
    distances.push_back((points.row(i) - mesh_.vertices.row(vertex_[i])).norm());
  if (median(std::move(distances)) <= mostApart(points(compared, Eigen::all), mesh_)) return true;
  std::fill(vertex_.begin(), vertex_.end(), -1);
  return false;
}

TargetMetric TargetPlaces::metric() const {
  return namingFile(path_, [&] { return TargetMetric(mesh_); });
}

int TargetPlaces::at(int target_vertex) const {
  return itself_ || target_vertex < 0 ? target_vertex : vertex_[target_vertex];
}

std::vector<VertexPair> TargetPlaces::onMesh(const std::vector<VertexPair>& pairs) const {
  std::vector<VertexPair> placed;
  for (const VertexPair& pair : pairs)
    if (at(pair.target) >= 0) placed.push_back({pair.source, at(pair.target)});
  return placed;
}

std::vector<SurfacePoint> TargetPlaces::onMesh(const std::vector<SurfacePoint>& places) const {
  if (itself_) return places;
  std::vector<SurfacePoint> placed(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) placed[i].vertex = at(places[i].vertex);
  return placed;
}

std::vector<int> TargetPlaces::onMesh(const std::vector<int>& target_vertex) const {
  std::vector<int> placed(target_vertex.size());
  std::transform(
      target_vertex.begin(), target_vertex.end(), placed.begin(), [&](int t) { return at(t); });
  return placed;
}

}  // namespace posture::app
