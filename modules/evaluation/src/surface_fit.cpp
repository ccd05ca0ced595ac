// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/evaluation/statistics.h>
#include <posture/evaluation/surface_fit.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>

#include <cmath>
#include <vector>

namespace posture {
namespace {

/// The logarithm of a collapsed edge's length is no figure: it counts as much as this one.
constexpr double LARGEST_STRETCH = 10;

std::vector<double> edgeStretches(const TriangleMesh& source,
                                  const Points& deformed,
                                  double scale) {
  std::vector<double> stretches;
  for (const Edge& e : meshEdges(source.faces)) {
    const double before =
        scale * (source.vertices.row(e.first) - source.vertices.row(e.second)).norm();
    const double after = (deformed.row(e.first) - deformed.row(e.second)).norm();
    if (!(before > 0)) continue;
    const double stretch = after > 0 ? std::abs(std::log(after / before)) : LARGEST_STRETCH;
    stretches.push_back(std::min(stretch, LARGEST_STRETCH));
  }
  return stretches;
}

}  // namespace

SurfaceFit measureFit(const TriangleMesh& source,
                      const Points& deformed,
                      double scale,
                      const TriangleMesh& target) {
  require(deformed.rows() == source.vertices.rows(),
          std::to_string(deformed.rows()) + " deformed vertices of " +
              std::to_string(source.vertices.rows()));
  require(source.faces.rows() > 0 && target.faces.rows() > 0, "a mesh without faces");
  const PointIndex index(target.vertices);
  const double edge = meanEdgeLength(target);
  std::vector<double> distances(deformed.rows());
  for (int v = 0; v < deformed.rows(); ++v)
    distances[v] = index.nearest(deformed.row(v)).distance / edge;
  const std::vector<double> stretches = edgeStretches(source, deformed, scale);
  return {percentile(distances, 0.5),
          percentile(distances, 0.95),
          mean(stretches),
          percentile(stretches, 0.95)};
}

}  // namespace posture
