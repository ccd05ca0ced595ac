// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/dense/dense_map.h>
#include <posture/dense/thin_plate_spline.h>
#include <posture/matching/consistency.h>
#include <posture/mesh/point_index.h>

#include <algorithm>
#include <cmath>

namespace posture {
namespace {

/// The target vertex nearest, in the embedding, to where the spline takes each source vertex; -1
/// where the spline breaks down.
std::vector<int> nearestVertices(const EmbeddedShape& source,
                                 const EmbeddedShape& target,
                                 const ThinPlateSpline& spline) {
  const PointIndex index(target.form.vertices);
  const int n = static_cast<int>(source.form.vertices.rows());
  std::vector<int> nearest(n);
  constexpr int BLOCK = 64;
  forEach(n, BLOCK, [&](int v) {
    const Eigen::RowVector3d place = spline(source.form.vertices.row(v));
    nearest[v] = place.allFinite() ? index.nearest(place).index : -1;
  });
  return nearest;
}

/// How far each vertex's pair agrees with the kernel's matches.
struct Agreement {
  std::vector<int> inconsistent;  ///< n: matches whose consistency with the pair is <= c0
  Vector mean;                    ///< n: mean consistency
};

/// Samples are matched one-to-one to samples that were chosen without regard to each other, so a
/// match lies beside its true place by up to the spacing of both: two lengths that differ by less
/// are no contradiction, whatever their ratio.
double matchUncertainty(const EmbeddedShape& source, const EmbeddedShape& target) {
  return source.landmarks.covering_radius + target.landmarks.covering_radius;
}

Agreement agreement(const EmbeddedShape& source,
                    const EmbeddedShape& target,
                    const std::vector<Match>& matches,
                    const std::vector<int>& target_vertex,
                    double threshold) {
  const int n = static_cast<int>(target_vertex.size());
  const double uncertainty = matchUncertainty(source, target);
  Agreement result{std::vector<int>(n, 0), Vector::Zero(n)};
  // Blocks of vertices keep a landmark's row of distances in cache.
  constexpr int BLOCK = 2048;
  forBlocks(n, BLOCK, [&](int first, int last) {
    for (const Match& match : matches) {
      const auto from_source = source.landmarks.distances.row(match.source);
      const auto from_target = target.landmarks.distances.row(match.target);
      for (int v = first; v < last; ++v) {
        if (target_vertex[v] < 0) continue;
        const double a = from_source[v], b = from_target[target_vertex[v]];
        const bool near = std::abs(a - b) <= uncertainty;
        const double c = lengthConsistency(a, b);
        result.inconsistent[v] += c <= threshold && !near;
        result.mean[v] += a == b ? 1 : c;
      }
    }
  });
  if (!matches.empty()) result.mean /= static_cast<double>(matches.size());
  return result;
}

}  // namespace

DenseMap computeDenseMap(const EmbeddedShape& source,
                         const EmbeddedShape& target,
                         const Candidate& candidate,
                         const std::vector<int>& kernel,
                         double threshold) {
  const int n = static_cast<int>(source.mesh.vertices.rows());
  DenseMap map{std::vector<int>(n, -1), Vector::Zero(n)};
  if (kernel.empty()) return map;
  std::vector<Match> matches;
  Points from(kernel.size(), 3), to(kernel.size(), 3);
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    matches.push_back(candidate.matches[kernel[i]]);
    from.row(i) = source.form.landmarks.row(matches[i].source);
    to.row(i) = target.form.landmarks.row(matches[i].target);
  }
  map.target_vertex = nearestVertices(source, target, ThinPlateSpline(from, to));
  const Agreement found = agreement(source, target, matches, map.target_vertex, threshold);
  for (int v = 0; v < n; ++v) {
    if (map.target_vertex[v] < 0 || found.inconsistent[v] > 0)
      map.target_vertex[v] = -1;
    else
      map.confidence[v] = std::clamp((found.mean[v] - threshold) / (1 - threshold), 0.0, 1.0);
  }
  return map;
}

std::vector<VertexPair> oneToOne(const DenseMap& map, int target_count) {
  std::vector<int> source_of(target_count, -1);
  for (std::size_t v = 0; v < map.target_vertex.size(); ++v) {
    const int t = map.target_vertex[v];
    if (t < 0) continue;
    if (source_of[t] < 0 || map.confidence[v] > map.confidence[source_of[t]])
      source_of[t] = static_cast<int>(v);
  }
  std::vector<VertexPair> pairs;
  for (int t = 0; t < target_count; ++t)
    if (source_of[t] >= 0) pairs.push_back({source_of[t], t});
  return pairs;
}

}  // namespace posture
