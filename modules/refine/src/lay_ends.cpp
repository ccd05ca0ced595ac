// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lay_ends.h"

#include <posture/core/parallel.h>
#include <posture/mesh/rigid_motion.h>

#include "even_rotations.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace posture {
namespace {

/// Lengths in square roots of the area. Ears and nose lie so far from each other.
constexpr double TIP_REACH = 0.25;

/// An end: a head, a hand, a foot; and by how much more of the other surface it may lie on.
constexpr double RADIUS = 0.1, MARGIN = 0.1;

/// Of its vertices, those on a rim where all of an end was seen but for a face or two. A stump has
/// 0.15 and more.
constexpr double MOST_ON_RIM = 0.05;

/// Places from which the mean distance is taken.
constexpr int PLACES = 80;

/// A normal turned by 90 degrees counts as much as a distance of 0.07.
constexpr double NORMAL_LENGTH = 0.05;

/// Of the distances the largest fifth does not count: what lies at the cut.
constexpr double TRIMMED = 0.8;

constexpr int TURNS = 72;

/// From all sides an end is laid by so many vertices of it and of what is around it.
constexpr std::size_t ROUGH = 250;

/// The ways that are gone on with: all for a few steps, the better third for some more, the best by
/// all vertices until they are at rest.
struct Round {
  int steps;
  std::size_t ways_left;
  double apart;  ///< turns by which those left differ at least
};
constexpr Round FIRST{4, 24, M_PI / 18}, SECOND{8, 5, SAME_TURN}, LAST{60, 5, SAME_TURN};

/// A step that changes the misfit by less is the last.
constexpr double AT_REST = 1e-3;

/// Geodesic distance from a tip, or from an ear or a nose beside it.
std::vector<double> distanceFromEnd(const SpectralSurface& surface, const Vector& remote, int tip) {
  const std::vector<double>& from_tip = surface.distances.from(tip);
  std::vector<double> distance = from_tip;
  for (int v = 0; v < remote.size(); ++v) {
    const VertexNeighbors& near = surface.within_two_edges;
    if (!(from_tip[v] < TIP_REACH) ||
        std::any_of(near.begin(v), near.end(v), [&](int w) { return remote[w] > remote[v]; }))
      continue;
    const std::vector<double>& from_it = surface.distances.from(v);
    for (std::size_t w = 0; w < distance.size(); ++w)
      distance[w] = std::min(distance[w], from_it[w]);
  }
  return distance;
}

double meanSquaredEdge(const SpectralSurface& surface, const LimbEnd& end) {
  double sum = 0, edges = 0;
  for (std::size_t i = 0; i < end.wide.size(); ++i) {
    if (!end.inside[i]) continue;
    const int v = end.wide[i];
    for (const int* w = surface.neighbors.begin(v); w != surface.neighbors.end(v); ++w, ++edges)
      sum += (surface.mesh.vertices.row(v) - surface.mesh.vertices.row(*w)).squaredNorm();
  }
  return sum / edges;
}

/// The same with its first vertices alone, which are spread evenly.
LimbEnd roughEnd(const LimbEnd& end) {
  const std::size_t n = std::min(ROUGH, end.wide.size());
  LimbEnd rough;
  rough.wide.assign(end.wide.begin(), end.wide.begin() + static_cast<std::ptrdiff_t>(n));
  rough.inside.assign(end.inside.begin(), end.inside.begin() + static_cast<std::ptrdiff_t>(n));
  rough.size = std::count(rough.inside.begin(), rough.inside.end(), 1);
  rough.places = end.places.topRows(static_cast<Eigen::Index>(n));
  rough.normals = end.normals.topRows(static_cast<Eigen::Index>(n));
  return rough;
}

/// What each vertex of either end is next to around the other one, without the farthest.
std::vector<ClosestPair> pairsOf(const LimbEnd& a,
                                 const LimbEnd& b,
                                 const Eigen::Isometry3d& motion) {
  const std::vector<ClosestPair> all = closestPairs(moved(motion, a.places),
                                                    a.normals * motion.linear().transpose(),
                                                    b.places,
                                                    b.normals,
                                                    NORMAL_LENGTH);
  std::vector<ClosestPair> pairs;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k < a.wide.size() ? a.inside[all[k].a] : b.inside[all[k].b]) pairs.push_back(all[k]);
  std::stable_sort(pairs.begin(), pairs.end(), [](const ClosestPair& x, const ClosestPair& y) {
    return x.squared < y.squared;
  });
  pairs.resize(static_cast<std::size_t>(TRIMMED * static_cast<double>(pairs.size())));
  return pairs;
}

void layCloser(const LimbEnd& a, const LimbEnd& b, int steps, LaidEnd& laid) {
  const auto meanOf = [](const std::vector<ClosestPair>& pairs) {
    double sum = 0;
    for (const ClosestPair& pair : pairs) sum += pair.squared;
    return sum / static_cast<double>(pairs.size());
  };
  laid.pairs = pairsOf(a, b, laid.motion);
  if (laid.pairs.empty()) return;
  laid.misfit = meanOf(laid.pairs);
  for (int step = 0; step < steps; ++step) {
    Points from(laid.pairs.size(), 3), to(laid.pairs.size(), 3);
    for (std::size_t i = 0; i < laid.pairs.size(); ++i) {
      from.row(i) = a.places.row(laid.pairs[i].a);
      to.row(i) = b.places.row(laid.pairs[i].b);
    }
    laid.motion = rigidMotion(from, to);
    laid.pairs = pairsOf(a, b, laid.motion);
    const double before = std::exchange(laid.misfit, meanOf(laid.pairs));
    if (std::abs(laid.misfit - before) < AT_REST * before) break;
  }
}

void goOn(const LimbEnd& a, const LimbEnd& b, const Round& round, std::vector<LaidEnd>& ways) {
  parallelFor(static_cast<int>(ways.size()), [&](int i) { layCloser(a, b, round.steps, ways[i]); });
  std::stable_sort(ways.begin(), ways.end());
  std::vector<LaidEnd> left;
  for (LaidEnd& way : ways)
    if (left.size() < round.ways_left &&
        std::none_of(left.begin(), left.end(), [&](const LaidEnd& better) {
          return angleBetween(better, way) <= round.apart;
        }))
      left.push_back(std::move(way));
  ways = std::move(left);
}

Eigen::RowVector3d middleOf(const LimbEnd& end) {
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (Eigen::Index i = 0; i < end.places.rows(); ++i)
    if (end.inside[i]) sum += end.places.row(i);
  return sum / static_cast<double>(end.size);
}

}  // namespace

Vector remoteness(const SpectralSurface& surface) {
  const int n = static_cast<int>(surface.mesh.vertices.rows()), places = std::min(PLACES, n);
  parallelFor(places, [&](int i) { surface.distances.from(i); });
  Vector sum = Vector::Zero(n);
  for (int i = 0; i < places; ++i)
    sum += Eigen::Map<const Vector>(surface.distances.from(i).data(), n);
  return sum / places;
}

LimbEnd endAt(const SpectralSurface& surface, const Vector& remote, int tip) {
  const std::vector<double> distance = distanceFromEnd(surface, remote, tip);
  LimbEnd end;
  for (int v = 0; v < remote.size(); ++v) {
    if (!(distance[v] < RADIUS + MARGIN)) continue;
    end.wide.push_back(v);
    end.inside.push_back(distance[v] < RADIUS);
    end.size += end.inside.back();
    if (end.inside.back() && surface.on_boundary[v] != 0) ++end.on_rim;
  }
  end.squared_edge = meanSquaredEdge(surface, end);
  end.places = surface.mesh.vertices(end.wide, Eigen::all);
  end.normals = surface.normals(end.wide, Eigen::all);
  return end;
}

bool isWhole(const LimbEnd& end) {
  return static_cast<double>(end.on_rim) <= MOST_ON_RIM * static_cast<double>(end.size);
}

LimbEnd mirrorImage(LimbEnd end) {
  end.places.col(0) *= -1;
  end.normals.col(0) *= -1;
  return end;
}

double angleBetween(const LaidEnd& x, const LaidEnd& y) {
  return Eigen::AngleAxisd(x.motion.linear() * y.motion.linear().transpose()).angle();
}

LaidEnd asMapped(const SpectralSurface& b, const LimbEnd& a, const VertexMaps& maps) {
  Points from(a.size, 3), to(a.size, 3);
  Eigen::Index n = 0;
  for (std::size_t i = 0; i < a.wide.size(); ++i) {
    if (!a.inside[i]) continue;
    from.row(n) = a.places.row(i);
    to.row(n++) = b.mesh.vertices.row(maps.forward[a.wide[i]]);
  }
  LaidEnd laid;
  laid.motion = rigidMotion(from, to);
  return laid;
}

std::vector<LaidEnd> waysToLay(const LimbEnd& a, const LimbEnd& b, const LaidEnd& mapped) {
  const LimbEnd rough_a = roughEnd(a), rough_b = roughEnd(b);
  const std::vector<Eigen::Matrix3d> turns = evenRotations(TURNS);
  const Eigen::Vector3d middle_a = middleOf(a), middle_b = middleOf(b);
  std::vector<LaidEnd> ways(1 + turns.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    Eigen::Isometry3d& motion = ways[i].motion;
    motion = mapped.motion;
    if (i == 0) continue;
    motion.linear() = turns[i - 1] * mapped.motion.linear();
    motion.translation() = middle_b - motion.linear() * middle_a;
  }
  goOn(rough_a, rough_b, FIRST, ways);
  goOn(rough_a, rough_b, SECOND, ways);
  goOn(a, b, LAST, ways);
  return ways;
}

}  // namespace posture
