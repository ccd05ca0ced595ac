// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/io/cut_polygon.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/pipeline/deformed_surface.h>
#include <posture/registration/register_clouds.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace posture {
namespace {

/// What the stages take of one side, and the way back to it.
struct Part {
  Shape shape;
  std::vector<int> row;   ///< of each of its points, among the side's
  std::vector<int> face;  ///< of each of its faces, among the triangles of the polygons
  Eigen::Index rows = 0;  ///< of the side

  bool isMesh() const { return !face.empty(); }
};

Part pointsOf(const CloudSide& side) {
  Part part{{side.cloud, {}}, std::vector<int>(side.number.size()), {}, side.cloud.points.rows()};
  std::iota(part.row.begin(), part.row.end(), 0);
  // As the readers of files have it.
  for (int i = 0; i < part.shape.cloud.normals.rows(); ++i)
    if (!part.shape.cloud.normals.row(i).allFinite()) part.shape.cloud.normals.row(i).setZero();
  return part;
}

/// As polygons of files are cut; one that lacks a corner's place as a fan.
std::vector<std::array<int, 3>> trianglesOf(const std::vector<int>& corners, const Points& points) {
  const int count = static_cast<int>(corners.size());
  if (count > 3 && *std::min_element(corners.begin(), corners.end()) >= 0)
    return cutPolygon(points(corners, Eigen::all));
  std::vector<std::array<int, 3>> fan;
  for (int k = 2; k < count; ++k) fan.push_back({0, k - 1, k});
  return fan;
}

Part meshOf(const CloudSide& side) {
  Part part{{}, finiteRows(side.cloud.points), {}, side.cloud.points.rows()};
  part.shape.cloud.points = side.cloud.points(part.row, Eigen::all);
  std::vector<int> vertex(side.total, -1);  // the first, where a point takes part twice
  for (int i = static_cast<int>(part.row.size()) - 1; i >= 0; --i)
    vertex[side.number[part.row[i]]] = i;
  std::vector<Eigen::RowVector3i> faces;
  int triangle = 0;
  for (const pcl::Vertices& polygon : side.polygons) {
    for (const auto corner : polygon.vertices)
      if (corner < 0 || static_cast<std::size_t>(corner) >= side.total)
        throw InputError("mesh names point " + std::to_string(corner) + " of " +
                         std::to_string(side.total));
    std::vector<int> corners;
    for (const auto corner : polygon.vertices) corners.push_back(vertex[corner]);
    for (const std::array<int, 3>& cut : trianglesOf(corners, part.shape.cloud.points)) {
      const Eigen::RowVector3i face(corners[cut[0]], corners[cut[1]], corners[cut[2]]);
      if (face.minCoeff() >= 0) {
        faces.push_back(face);
        part.face.push_back(triangle);
      }
      ++triangle;
    }
  }
  if (faces.empty()) throw InputError("mesh has no triangle with all its corners among the points");
  part.shape.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) part.shape.faces.row(f) = faces[f];
  return part;
}

Part partOf(const std::string& name, const CloudSide& side) {
  if (!side.fault.empty()) throw InputError(name + " " + side.fault);
  if (side.cloud.points.rows() == 0) throw InputError(name + " has no points");
  if (side.polygons.empty()) return pointsOf(side);
  return naming(name, [&] { return meshOf(side); });
}

SurfacePoint referred(SurfacePoint place, const Part& to) {
  if (place.vertex >= 0) place.vertex = to.row[place.vertex];
  if (place.face >= 0 && to.isMesh()) place.face = to.face[place.face];
  return place;
}

Correspondence referred(const Correspondence& map, const Part& from, const Part& to) {
  Correspondence rows{std::vector<SurfacePoint>(from.rows), Vector::Zero(from.rows)};
  for (std::size_t i = 0; i < map.on_target.size(); ++i) {
    rows.on_target[from.row[i]] = referred(map.on_target[i], to);
    rows.confidence[from.row[i]] = map.confidence[i];
  }
  return rows;
}

std::vector<int> referred(const std::vector<int>& target_vertex, const Part& from, const Part& to) {
  std::vector<int> rows(from.rows, -1);
  for (std::size_t i = 0; i < target_vertex.size(); ++i)
    if (target_vertex[i] >= 0) rows[from.row[i]] = to.row[target_vertex[i]];
  return rows;
}

/// Places of a side's points: of those that took no part, where they were.
Points referred(const Points& places, const Part& part, Points points) {
  points(part.row, Eigen::all) = places;
  return points;
}

/// Rewrites a result between two parts in terms of the points of the sides.
void referToSides(const Part& source,
                  const Points& source_points,
                  const Part& target,
                  const Points& target_points,
                  RegistrationResult& result) {
  result.correspondence = referred(result.correspondence, source, target);
  if (result.back)
    result.back->correspondence = referred(result.back->correspondence, target, source);
  for (HypothesisSummary& hypothesis : result.hypotheses)
    hypothesis.target_vertex = referred(hypothesis.target_vertex, source, target);
  for (AlternativeSummary& alternative : result.alternatives) {
    alternative.target_vertex = referred(alternative.target_vertex, source, target);
    if (!alternative.correspondence.on_target.empty())
      alternative.correspondence = referred(alternative.correspondence, source, target);
  }
  result.deformed = referred(result.deformed, source, source_points);
  if (result.source_denoised.rows() > 0)
    result.source_denoised = referred(result.source_denoised, source, source_points);
  if (result.target_denoised.rows() > 0)
    result.target_denoised = referred(result.target_denoised, target, target_points);
}

void addMatches(const CloudSide& source, const CloudSide& target, RegisteredClouds& clouds) {
  const RegistrationResult& result = clouds.result;
  const std::vector<SurfacePoint>& on_target = result.correspondence.on_target;
  for (int i = 0; i < static_cast<int>(on_target.size()); ++i) {
    const int t = on_target[i].vertex;
    if (t < 0) continue;
    const double distance_sq = (result.deformed.row(i) - target.cloud.points.row(t)).squaredNorm();
    clouds.matches.emplace_back(
        source.number[i], target.number[t], static_cast<float>(distance_sq));
    if (result.back && result.back->correspondence.on_target[t].vertex == i)
      clouds.reciprocal_matches.push_back(clouds.matches.back());
  }
}

/// Of the points that have a counterpart.
Eigen::Isometry3d bestRigidMotion(const Points& source,
                                  const Points& target,
                                  const Correspondence& correspondence) {
  std::vector<int> from, to;
  for (std::size_t i = 0; i < correspondence.on_target.size(); ++i)
    if (correspondence.on_target[i].vertex >= 0) {
      from.push_back(static_cast<int>(i));
      to.push_back(correspondence.on_target[i].vertex);
    }
  return rigidMotion(source(from, Eigen::all), target(to, Eigen::all));
}

RegisteredClouds registered(const CloudSide& source,
                            const CloudSide& target,
                            const RegistrationOptions& options,
                            const Observer& observer) {
  const Part from = partOf("source", source), to = partOf("target", target);
  RegisteredClouds clouds;
  clouds.result = registerShapes(from.shape, to.shape, options, observer);
  RegistrationResult& result = clouds.result;
  clouds.T_target_source = bestRigidMotion(registeredPoints(from.shape, result.source_denoised),
                                           registeredPoints(to.shape, result.target_denoised),
                                           result.correspondence);
  clouds.surface = deformedSurface(from.shape, result);
  clouds.normals = turnedNormals(clouds.surface, source.cloud);
  referToSides(from, source.cloud.points, to, target.cloud.points, result);
  addMatches(source, target, clouds);
  return clouds;
}

}  // namespace

RegisteredClouds registerClouds(const CloudSide& source,
                                const CloudSide& target,
                                const RegistrationOptions& options,
                                const Observer& observer) {
  bool observer_threw = false;
  const Observer guarded = [&](const StageEvent& event) {
    try {
      observer(event);
    } catch (...) {
      observer_threw = true;
      throw;
    }
  };
  try {
    return registered(source, target, options, observer ? guarded : Observer());
  } catch (const std::runtime_error& error) {  // running out of memory is none
    if (observer_threw) throw;
    RegisteredClouds none;
    none.result.message = error.what();
    return none;
  }
}

PointCloud deformed(const RegisteredClouds& clouds, PointCloud points) {
  return applyDeformation(clouds.surface, std::move(points));
}

double meanSquaredDistance(const Points& points, const Points& target, double max_range) {
  constexpr double NONE = std::numeric_limits<double>::max();
  const std::vector<int> seen = finiteRows(target);
  if (seen.empty()) return NONE;
  const PointIndex index(target(seen, Eigen::all));
  double sum = 0;
  int count = 0;
  for (int i : finiteRows(points)) {
    const double distance = index.nearest(points.row(i).transpose()).distance;
    if (distance * distance > max_range) continue;
    sum += distance * distance;
    ++count;
  }
  return count > 0 ? sum / count : NONE;
}

}  // namespace posture
