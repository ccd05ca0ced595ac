// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/pipeline/segment_shape.h>

#include "sides/leave_out_background.h"
#include <cmath>

namespace posture {
namespace {

/// Root mean square of what a part's motion leaves.
std::vector<double> residuals(const RigidSegments& parts,
                              std::size_t pose,
                              const Points& rest,
                              const Points& places) {
  std::vector<double> sum(parts.count, 0), vertices(parts.count, 0);
  for (int v = 0; v < rest.rows(); ++v) {
    const int part = parts.label[v];
    if (part < 0) continue;
    const Eigen::Vector3d at = parts.scale[pose] * rest.row(v).transpose();
    sum[part] += (parts.motion[pose][part] * at - places.row(v).transpose()).squaredNorm();
    ++vertices[part];
  }
  for (int part = 0; part < parts.count; ++part)
    sum[part] = vertices[part] > 0 ? std::sqrt(sum[part] / vertices[part]) : 0;
  return sum;
}

}  // namespace

ShapeSegments segmentShape(const Shape& source, const std::vector<RegistrationResult>& poses) {
  require(!poses.empty(), "segmentShape: no pose");
  const std::optional<ScanSurface>& scan = poses.front().source_scan;
  TriangleMesh rest = registeredMesh(source, scan, poses.front().source_denoised);
  const Background background = leaveOutBackground(rest);
  ShapeSegments segments;
  segments.surface = cleanMesh(rest);
  const CleanMesh& surface = segments.surface;
  std::vector<Points> places;
  for (const RegistrationResult& pose : poses) {
    const Points& moved = scan ? pose.surface_deformed : pose.deformed;
    require(moved.rows() == rest.vertices.rows(), "segmentShape: a pose of another source");
    places.emplace_back(moved(surface.input_vertex, Eigen::all));
  }
  segments.parts = segmentRigidParts(surface.mesh, places);
  for (std::size_t k = 0; k < places.size(); ++k)
    segments.residual.push_back(residuals(segments.parts, k, surface.mesh.vertices, places[k]));

  const auto labelOf = [&](int v) {
    const bool is_behind = !background.vertices.empty() && background.vertices[v] != 0;
    return is_behind ? -1 : segments.parts.label[surface.clean_vertex[v]];
  };
  if (scan)
    for (const SurfacePoint& at : scan->on_mesh)
      segments.label.push_back(at.vertex >= 0 ? labelOf(at.vertex) : -1);
  else
    for (int v = 0; v < rest.vertices.rows(); ++v) segments.label.push_back(labelOf(v));
  return segments;
}

}  // namespace posture
