// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/core/parallel.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/refine/lay_over.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "closest_pairs.h"
#include "even_rotations.h"
#include "robust_weight.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

/// Lengths are in square roots of the area: a normal turned by 90 degrees counts as much as a
/// distance of 0.3, half the thickness of a trunk.
constexpr double NORMAL_LENGTH = 0.2;

/// With 400 places the score of what is laid varies by 0.5, as much as the rabbit's front and back
/// of the captures differ by.
constexpr int PLACES = 800;

constexpr int ROTATIONS = 72, RIGID_STEPS = 15, SCALED_STEPS = 15, FINAL_STEPS = 60;

/// Two ways closer than this in the mean lead to the same place.
constexpr double SAME_WAY = 0.1;

/// What the rim of a hole is near to says little.
constexpr double RIM_WEIGHT = 0.1;

/// Vertices spread evenly, from the one farthest from the middle on: each is the farthest from
/// those before it, in space; of several the one whose place comes first.
std::vector<int> spreadVertices(const Points& vertices) {
  const auto before = [&](int v, int w) {
    for (int k = 0; k < 3; ++k)
      if (vertices(v, k) != vertices(w, k)) return vertices(v, k) < vertices(w, k);
    return false;
  };
  const int n = static_cast<int>(vertices.rows());
  Vector squared = (vertices.rowwise() - vertices.colwise().mean()).rowwise().squaredNorm();
  std::vector<int> spread;
  while (static_cast<int>(spread.size()) < std::min(PLACES, n)) {
    int next = 0;
    for (int v = 1; v < n; ++v)
      if (squared[v] > squared[next] || (squared[v] == squared[next] && before(v, next))) next = v;
    const Vector from_it = (vertices.rowwise() - vertices.row(next)).rowwise().squaredNorm();
    squared = spread.empty() ? from_it : squared.cwiseMin(from_it).eval();
    spread.push_back(next);
  }
  return spread;
}

struct Laying {
  Similarity way;
  double cost = 0;  ///< mean distance
};

double medianSquared(const std::vector<ClosestPair>& pairs) {
  std::vector<double> squared;
  squared.reserve(pairs.size());
  for (const ClosestPair& p : pairs) squared.push_back(p.squared);
  return std::max(median(std::move(squared)), 1e-12);
}

/// The similarity that best takes the first of each pair to the second (Horn 1987); a scale of
/// both directions alike, so that matching to what is nearest does not shrink.
Similarity bestSimilarity(const SurfacePlaces& a,
                          const SurfacePlaces& b,
                          const std::vector<ClosestPair>& pairs,
                          const Vector& weight,
                          bool scaled,
                          double scale) {
  Eigen::RowVector3d mean_a = Eigen::RowVector3d::Zero(), mean_b = mean_a;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    mean_a += weight[i] * a.places.row(pairs[i].a);
    mean_b += weight[i] * b.places.row(pairs[i].b);
  }
  mean_a /= weight.sum();
  mean_b /= weight.sum();
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  double spread_a = 0, spread_b = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Eigen::RowVector3d x = a.places.row(pairs[i].a) - mean_a,
                             y = b.places.row(pairs[i].b) - mean_b;
    moment += weight[i] * y.transpose() * x;
    spread_a += weight[i] * x.squaredNorm();
    spread_b += weight[i] * y.squaredNorm();
  }
  // As nearestRotation(), whose last bits differ here: what is laid hangs on them in close cases.
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d sign(1, 1, 1);
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) sign[2] = -1;
  Similarity way;
  way.rotation = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  way.scale = scaled && spread_a > 0 && spread_b > 0 ? std::sqrt(spread_b / spread_a) : scale;
  way.translation = mean_b - way.scale * mean_a * way.rotation.transpose();
  return way;
}

void closestPoints(
    const SurfacePlaces& a, const SurfacePlaces& b, int steps, bool scaled, Laying& laying) {
  for (int step = 0; step < steps; ++step) {
    const std::vector<ClosestPair> pairs = closestPairs(laying.way.of(a.places),
                                                        a.normals * laying.way.rotation.transpose(),
                                                        b.places,
                                                        b.normals,
                                                        NORMAL_LENGTH);
    const double usual = medianSquared(pairs);
    Vector weight(pairs.size());
    laying.cost = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool rim = a.on_boundary[pairs[i].a] || b.on_boundary[pairs[i].b];
      weight[i] = gemanMcClure(pairs[i].squared / usual) * (rim ? RIM_WEIGHT : 1);
      laying.cost += std::sqrt(pairs[i].squared) / static_cast<double>(pairs.size());
    }
    laying.way = bestSimilarity(a, b, pairs, weight, scaled, laying.way.scale);
  }
}

}  // namespace

SurfacePlaces::SurfacePlaces(const TriangleMesh& mesh) {
  const std::vector<int> spread = spreadVertices(mesh.vertices);
  const std::vector<char> rim =
      boundaryVertices(mesh.faces, static_cast<int>(mesh.vertices.rows()));
  places = mesh.vertices(spread, Eigen::all);
  normals = vertexNormals(mesh)(spread, Eigen::all);
  for (const int v : spread) on_boundary.push_back(rim[v]);
}

Points Similarity::of(const Points& points) const {
  return (scale * points * rotation.transpose()).rowwise() + translation;
}

Points Similarity::inverseOf(const Points& points) const {
  return ((points.rowwise() - translation) * rotation) / scale;
}

std::vector<Similarity> layOver(const SurfacePlaces& a, const SurfacePlaces& b, int most) {
  const std::vector<Eigen::Matrix3d> starts = evenRotations(ROTATIONS);
  const Eigen::RowVector3d middle_a = a.places.colwise().mean(),
                           middle_b = b.places.colwise().mean();
  std::vector<Laying> layings(starts.size());
  parallelFor(static_cast<int>(starts.size()), [&](int i) {
    layings[i].way.rotation = starts[i];
    layings[i].way.translation = middle_b - middle_a * starts[i].transpose();
    closestPoints(a, b, RIGID_STEPS, false, layings[i]);
    closestPoints(a, b, SCALED_STEPS, true, layings[i]);
  });
  const auto byCost = [](const Laying& x, const Laying& y) { return x.cost < y.cost; };
  std::stable_sort(layings.begin(), layings.end(), byCost);
  std::vector<Laying> kept;
  const auto isNew = [&](const Laying& laying) {
    const Points places = laying.way.of(a.places);
    return std::none_of(kept.begin(), kept.end(), [&](const Laying& known) {
      return (places - known.way.of(a.places)).rowwise().norm().mean() < SAME_WAY;
    });
  };
  for (Laying& laying : layings) {
    if (static_cast<int>(kept.size()) >= most) break;
    if (!isNew(laying)) continue;
    // On their last steps two ways may come to be one.
    closestPoints(a, b, FINAL_STEPS, true, laying);
    if (isNew(laying)) kept.push_back(laying);
  }
  std::stable_sort(kept.begin(), kept.end(), byCost);
  std::vector<Similarity> ways;
  ways.reserve(kept.size());
  for (const Laying& laying : kept) ways.push_back(laying.way);
  return ways;
}

}  // namespace posture
