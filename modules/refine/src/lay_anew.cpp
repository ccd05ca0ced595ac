// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lay_anew.h"

#include <posture/mesh/connected_parts.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/refine/bent_pair.h>
#include <posture/refine/conform.h>
#include <posture/refine/settle.h>

#include <Eigen/Geometry>

#include "rings_around.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace posture {
namespace {

/// How much of the surface around a part tells how it goes, in square roots of the area.
constexpr double SURROUNDINGS = 0.15;
constexpr std::size_t FEWEST = 6;  ///< vertices that tell a motion

/// Rotations and places alternate so often where a part is laid anew.
constexpr int LAYING_STEPS = 50;

/// The vertices around a part that are not marked themselves.
std::vector<int> surroundings(const BendableSurface& a,
                              const std::vector<int>& part,
                              const std::vector<char>& marked) {
  const long rings = std::max(1L, std::lround(SURROUNDINGS / meanEdgeLength(a.mesh)));
  return ringsAround(a, part, marked, rings);
}

/// What of the vertices marked lies farther than an edge from its match on `b`.
std::vector<char> stillApart(const BendableSurface& b,
                             const std::vector<int>& matches,
                             const Points& bent,
                             std::vector<char> marked) {
  const double edge = meanEdgeLength(b.mesh);
  for (int v = 0; v < bent.rows(); ++v)
    if ((bent.row(v) - b.mesh.vertices.row(matches[v])).norm() < edge) marked[v] = 0;
  return marked;
}

}  // namespace

Points placesAnew(const BendableSurface& a,
                  const std::vector<char>& marked,
                  double softness,
                  const Points& bent) {
  Points laid = bent;
  for (const std::vector<int>& part : markedParts(a.neighbors, marked)) {
    const std::vector<int> around = surroundings(a, part, marked);
    if (around.size() < FEWEST) continue;
    const Eigen::Isometry3d motion =
        rigidMotion(a.mesh.vertices(around, Eigen::all), bent(around, Eigen::all));
    for (int v : part) laid.row(v) = (motion * Eigen::Vector3d(a.mesh.vertices.row(v))).transpose();
  }
  Vector held = Vector::Ones(laid.rows());
  for (int v = 0; v < laid.rows(); ++v)
    if (marked[v]) held[v] = 0;
  return a.arap.pull(laid, laid, a.arap.attract(softness, held), LAYING_STEPS);
}

bool addApart(std::vector<char>& marked, const std::vector<char>& apart) {
  bool more = false;
  for (std::size_t v = 0; v < marked.size(); ++v) {
    const bool known = isApart(apart, v);
    more |= marked[v] && !known;
    marked[v] |= known;
  }
  return more;
}

void dropIfNothingIsApart(BentPair& pair) {
  for (std::vector<char>* apart : {&pair.apart_a, &pair.apart_b})
    if (std::find(apart->begin(), apart->end(), 1) == apart->end()) apart->clear();
}

BentPair laidAnew(const SpectralSurface& a,
                  const SpectralSurface& b,
                  const std::vector<char>& of_a,
                  const std::vector<char>& of_b,
                  double softness,
                  const BentPair& pair) {
  BentPair loose = conform(
      a, b, placesAnew(a, of_a, softness, pair.bent_a), placesAnew(b, of_b, softness, pair.bent_b));
  const auto leaveApart = [&](const std::vector<char>& some_a, const std::vector<char>& some_b) {
    loose.apart_a = stillApart(b, loose.maps.forward, loose.bent_a, some_a);
    loose.apart_b = stillApart(a, loose.maps.backward, loose.bent_b, some_b);
  };
  leaveApart(of_a, of_b);
  settleSoftening(a, b, softness, loose);
  leaveApart(std::vector<char>(loose.apart_a), std::vector<char>(loose.apart_b));
  dropIfNothingIsApart(loose);
  return loose;
}

}  // namespace posture
