// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/map_score.h>
#include <posture/refine/partners.h>

#include <Eigen/Geometry>

#include "belief.h"
#include "functional_map.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace posture {
namespace {

/// Sizes of basis: bending wants the body's large forms, curvature its details too.
constexpr int BENDING_BASIS = 60, DETAIL_BASIS = 100;

/// Places between which distances are compared: all pairs of so many.
constexpr int DISTANCE_SAMPLES = 80;

/// A change of distance counts up to here, so that a path that a hole blocks does not outweigh
/// those that agree.
constexpr double LARGEST_CHANGE = 0.5;

/// In square roots of the area, the size of a hand: what misses by more has gone elsewhere.
constexpr double RETURN_LENGTH = 0.05;

/// A few per cent of the matches miss for no more reason than the size of the triangles.
constexpr double USUAL_MISS = 0.02;

/// The logarithm of what is left must not be infinite.
constexpr double LEAST_KEPT = 0.01;

/// A map onto the rims alone says nothing.
constexpr double LEAST_COVERED = 0.01;

double bendingEnergy(const SpectralSurface& from,
                     const SpectralSurface& to,
                     const std::vector<int>& matches,
                     const Vector& believed,
                     int k,
                     double softness) {
  const Points goals = to.mesh.vertices(matches, Eigen::all);
  const Arap::Attraction attraction = from.arap.attract(softness, believed);
  return from.arap.energy(
      from.arap.pull(lowPass(from, goals, k), goals, attraction, 2 * BENDING_STEPS));
}

/// Mean curvature, positive where the surface bulges, smoothed.
Vector meanCurvature(const SpectralSurface& s, int k) {
  const Points integrated = s.laplacian.stiffness * s.mesh.vertices;
  const Vector along_normal = 0.5 * integrated.cwiseProduct(s.normals).rowwise().sum();
  return lowPass(s, along_normal.cwiseQuotient(s.laplacian.mass), k);
}

double correlation(const Vector& x, const Vector& y, const Vector& mass) {
  if (!(mass.sum() > 0)) return 0;
  const Vector w = mass / mass.sum();
  const Vector dx = x.array() - w.dot(x), dy = y.array() - w.dot(y);
  const double spread = std::sqrt(w.dot(dx.cwiseAbs2()) * w.dot(dy.cwiseAbs2()));
  return spread > 0 ? w.dot(dx.cwiseProduct(dy)) / spread : 1;
}

/// Distances between evenly spread places and between their images.
double distanceChange(const SpectralSurface& from,
                      const SpectralSurface& to,
                      const std::vector<int>& matches,
                      const Vector& believed) {
  std::vector<int> places, images;
  const int samples = std::min(DISTANCE_SAMPLES, static_cast<int>(matches.size()));
  for (int v = 0; v < samples; ++v)
    if (believed[v] > 0) {
      places.push_back(v);
      images.push_back(matches[v]);
    }
  double change = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const std::vector<double>&here = from.distances.from(places[i]),
          &there = to.distances.from(images[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const double x = here[places[j]], y = there[images[j]];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      change += std::min(LARGEST_CHANGE, 2 * std::abs(x - y) / (x + y));
      ++pairs;
    }
  }
  return pairs > 0 ? change / static_cast<double>(pairs) : LARGEST_CHANGE;
}

double returnMiss(const SpectralSurface& from,
                  const std::vector<int>& there,
                  const std::vector<int>& back,
                  const Vector& believed) {
  double missed = 0;
  for (Eigen::Index v = 0; v < believed.size(); ++v) {
    const double miss =
        (from.mesh.vertices.row(v) - from.mesh.vertices.row(back[there[v]])).norm() / RETURN_LENGTH;
    missed += believed[v] * miss * miss / (1 + miss * miss);
  }
  return believed.sum() > 0 ? missed / believed.sum() : 1;
}

double oneWayOrientation(const SpectralSurface& a,
                         const SpectralSurface& b,
                         const std::vector<int>& map) {
  double vote = 0, area = 0;
  for (int f = 0; f < a.mesh.faces.rows(); ++f) {
    Eigen::Matrix3d corners;
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const int at = map[a.mesh.faces(f, k)];
      corners.col(k) = b.mesh.vertices.row(at).transpose();
      expected += b.normals.row(at).transpose();
    }
    const Eigen::Vector3d normal =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const double agreement = normal.dot(expected), weight = normal.norm();
    vote += agreement > 0 ? weight : (agreement < 0 ? -weight : 0);
    area += weight;
  }
  return area > 0 ? vote / area : 0;
}

Vector beliefBent(const SpectralSurface& from,
                  const SpectralSurface& to,
                  const BentPair& pair,
                  bool laid) {
  Vector believed = belief(from, to, pair.maps.forward);
  const std::vector<char> without = withoutPartner(from, to, pair, {laid});
  for (std::size_t v = 0; v < without.size(); ++v)
    if (without[v] != 0) believed[static_cast<Eigen::Index>(v)] = 0;
  return believed;
}

MapScore score(const SpectralSurface& a,
               const SpectralSurface& b,
               const VertexMaps& maps,
               const Vector& believed_a,
               const Vector& believed_b) {
  const Vector mass_a = a.laplacian.mass.cwiseProduct(believed_a),
               mass_b = b.laplacian.mass.cwiseProduct(believed_b);
  MapScore result;
  const int k = basisSize(a, b, BENDING_BASIS);
  const double softness = eigenvalueAt(a, b, k);
  const double covered =
      std::min(mass_a.sum() / a.laplacian.mass.sum(), mass_b.sum() / b.laplacian.mass.sum());
  result.bending = 0.5 *
                   (bendingEnergy(a, b, maps.forward, believed_a, k, softness) +
                    bendingEnergy(b, a, maps.backward, believed_b, k, softness)) /
                   std::max(covered, LEAST_COVERED);

  const int detail = basisSize(a, b, DETAIL_BASIS);
  const Vector curvature_a = meanCurvature(a, detail), curvature_b = meanCurvature(b, detail);
  result.curvature = 1 - 0.5 * (correlation(curvature_a, curvature_b(maps.forward), mass_a) +
                                correlation(curvature_b, curvature_a(maps.backward), mass_b));
  result.distortion = 0.5 * (distanceChange(a, b, maps.forward, believed_a) +
                             distanceChange(b, a, maps.backward, believed_b));
  result.return_miss = 0.5 * (returnMiss(a, maps.forward, maps.backward, believed_a) +
                              returnMiss(b, maps.backward, maps.forward, believed_b));
  return result;
}

}  // namespace

double MapScore::total() const {
  // A perfect map must not win by a lucky zero in one term.
  constexpr double LEAST = 1e-4;
  // Each of the four terms by the share of the surface that it was measured on.
  const double kept = std::max(LEAST_KEPT, 1 - let_go);
  double sum = std::log(USUAL_MISS + return_miss) - 4 * std::log(kept);
  for (double term : {bending, curvature, distortion}) sum += std::log(std::max(LEAST, term));
  // std::max hides what is no number.
  return std::isfinite(bending + curvature + distortion + return_miss)
             ? sum
             : std::numeric_limits<double>::infinity();
}

double MapScore::totalOfPiece() const {
  MapScore piece = *this;
  // Bending was divided by the share of the larger one.
  piece.bending *= std::max(LEAST_KEPT, 1 - let_go) / std::max(LEAST_KEPT, 1 - least_let_go);
  piece.let_go = least_let_go;
  return piece.total();
}

MapScore scoreMaps(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps) {
  return score(a, b, maps, belief(a, b, maps.forward), belief(b, a, maps.backward));
}

MapScore scoreBent(const SpectralSurface& a,
                   const SpectralSurface& b,
                   const BentPair& pair,
                   bool laid) {
  MapScore bent =
      score(a, b, pair.maps, beliefBent(a, b, pair, laid), beliefBent(b, a, reversed(pair), laid));
  std::tie(bent.least_let_go, bent.let_go) =
      std::minmax({areaShare(a, pair.apart_a), areaShare(b, pair.apart_b)});
  return bent;
}

double orientation(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps) {
  return 0.5 * (oneWayOrientation(a, b, maps.forward) + oneWayOrientation(b, a, maps.backward));
}

}  // namespace posture
