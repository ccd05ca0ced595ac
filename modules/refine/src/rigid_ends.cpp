// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/refine/rigid_ends.h>

#include <Eigen/Geometry>

#include "closest_pairs.h"
#include "even_rotations.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace posture {
namespace {

/// Lengths in square roots of the area. Ears and nose lie so far from each other.
constexpr double TIP_REACH = 0.25;

/// An end: a head, a hand, a foot; and by how much more of the other surface it may lie on.
constexpr double RADIUS = 0.1, MARGIN = 0.1;

/// Vertices of an end that tell a motion; whether they tell it well is seen by the other ways.
constexpr std::size_t FEWEST = 20;

/// Of its vertices, those on a rim where all of an end was seen but for a face or two. A stump has
/// 0.15 and more.
constexpr double MOST_ON_RIM = 0.05;

/// Places from which the mean distance is taken.
constexpr int PLACES = 80;

/// A normal turned by 90 degrees counts as much as a distance of 0.07.
constexpr double NORMAL_LENGTH = 0.05;

/// Of the distances the largest fifth does not count: what lies at the cut.
constexpr double TRIMMED = 0.8;

constexpr int TURNS = 72, MOST_STEPS = 20;

/// From all sides an end is laid by so many vertices of it and of what is around it; so many ways
/// are then gone on with by all vertices.
constexpr std::size_t ROUGH = 250, MOST_WAYS = 8;

/// A step that changes the misfit by less is the last.
constexpr double AT_REST = 1e-3;

/// Motions that turn by less from each other are one.
constexpr double SAME_TURN = M_PI / 6;

/// Of the misfit in the next best way: heads of cats and horses have 0.3 to 0.4, people's hands and
/// feet on finer meshes 0.2 to 0.5, other ends 0.6 and more.
constexpr double CLEARLY_BETTER = 0.5;

/// An end that fits so many times worse does not fit: on a stump it may have thirty times the
/// misfit, and would outvote all others.
constexpr double DOES_NOT_FIT = 2;

/// Of the mean squared edge, the misfit that says something: twice that of a surface on itself with
/// its vertices elsewhere (the second moment of a hexagon's places). A round end has less in many
/// ways.
constexpr double SAMPLING = 0.28;

constexpr std::size_t PLACES_ON_END = 5;

/// Mean geodesic distance from places all over the surface. The first vertices are spread evenly.
Vector remoteness(const SpectralSurface& surface) {
  const int n = static_cast<int>(surface.mesh.vertices.rows()), places = std::min(PLACES, n);
  parallelFor(places, [&](int i) { surface.distances.from(i); });
  Vector sum = Vector::Zero(n);
  for (int i = 0; i < places; ++i)
    sum += Eigen::Map<const Vector>(surface.distances.from(i).data(), n);
  return sum / places;
}

/// The end of a limb and what is around it.
struct End {
  std::vector<int> wide;     // vertices within RADIUS + MARGIN
  std::vector<char> inside;  // for each of them, whether it is within RADIUS
  Points places, normals;    // of `wide`
  std::size_t size = 0;      // of the end
  double squared_edge = 0;   // mean, of the end
  std::size_t on_rim = 0;    // of the end
};

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

double meanSquaredEdge(const SpectralSurface& surface, const End& end) {
  double sum = 0, edges = 0;
  for (std::size_t i = 0; i < end.wide.size(); ++i) {
    if (!end.inside[i]) continue;
    const int v = end.wide[i];
    for (const int* w = surface.neighbors.begin(v); w != surface.neighbors.end(v); ++w, ++edges)
      sum += (surface.mesh.vertices.row(v) - surface.mesh.vertices.row(*w)).squaredNorm();
  }
  return sum / edges;
}

End endAt(const SpectralSurface& surface, const Vector& remote, int tip) {
  const std::vector<double> distance = distanceFromEnd(surface, remote, tip);
  End end;
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

bool isWhole(const End& end) {
  return static_cast<double>(end.on_rim) <= MOST_ON_RIM * static_cast<double>(end.size);
}

/// The same with its first vertices alone, which are spread evenly.
End roughEnd(const End& end) {
  const std::size_t n = std::min(ROUGH, end.wide.size());
  End rough;
  rough.wide.assign(end.wide.begin(), end.wide.begin() + static_cast<std::ptrdiff_t>(n));
  rough.inside.assign(end.inside.begin(), end.inside.begin() + static_cast<std::ptrdiff_t>(n));
  rough.size = std::count(rough.inside.begin(), rough.inside.end(), 1);
  rough.places = end.places.topRows(static_cast<Eigen::Index>(n));
  rough.normals = end.normals.topRows(static_cast<Eigen::Index>(n));
  return rough;
}

/// An end laid on another one.
struct Laid {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  double misfit = std::numeric_limits<double>::infinity();
  std::vector<ClosestPair> pairs;  // rows of both, without the farthest

  bool operator<(const Laid& other) const { return misfit < other.misfit; }
};

double angleBetween(const Laid& x, const Laid& y) {
  return Eigen::AngleAxisd(x.motion.linear() * y.motion.linear().transpose()).angle();
}

/// What each vertex of either end is next to around the other one, without the farthest.
std::vector<ClosestPair> pairsOf(const End& a, const End& b, const Eigen::Isometry3d& motion) {
  const Eigen::Matrix3d back = motion.linear().transpose();
  const std::vector<ClosestPair> all =
      closestPairs((a.places * back).rowwise() + motion.translation().transpose(),
                   a.normals * back,
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

void layCloser(const End& a, const End& b, Laid& laid) {
  const auto meanOf = [](const std::vector<ClosestPair>& pairs) {
    double sum = 0;
    for (const ClosestPair& pair : pairs) sum += pair.squared;
    return sum / static_cast<double>(pairs.size());
  };
  laid.pairs = pairsOf(a, b, laid.motion);
  if (laid.pairs.empty()) return;
  laid.misfit = meanOf(laid.pairs);
  for (int step = 0; step < MOST_STEPS; ++step) {
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

Eigen::RowVector3d middleOf(const End& end) {
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (Eigen::Index i = 0; i < end.places.rows(); ++i)
    if (end.inside[i]) sum += end.places.row(i);
  return sum / static_cast<double>(end.size);
}

/// As the map lays it.
Laid asMapped(const SpectralSurface& b, const End& a, const VertexMaps& maps) {
  Points from(a.size, 3), to(a.size, 3);
  Eigen::Index n = 0;
  for (std::size_t i = 0; i < a.wide.size(); ++i) {
    if (!a.inside[i]) continue;
    from.row(n) = a.places.row(i);
    to.row(n++) = b.mesh.vertices.row(maps.forward[a.wide[i]]);
  }
  Laid laid;
  laid.motion = rigidMotion(from, to);
  return laid;
}

/// The best ways to lay an end on another one, each turned against the better ones; best first.
std::vector<Laid> waysToLay(const End& a, const End& b, const Laid& mapped) {
  const End rough_a = roughEnd(a), rough_b = roughEnd(b);
  const std::vector<Eigen::Matrix3d> turns = evenRotations(TURNS);
  const Eigen::Vector3d middle_a = middleOf(a), middle_b = middleOf(b);
  std::vector<Laid> ways(1 + turns.size());
  parallelFor(static_cast<int>(ways.size()), [&](int i) {
    Laid& way = ways[i];
    if (i == 0) {
      way.motion = mapped.motion;
    } else {
      way.motion.linear() = turns[i - 1] * mapped.motion.linear();
      way.motion.translation() = middle_b - way.motion.linear() * middle_a;
    }
    layCloser(rough_a, rough_b, way);
  });
  const auto leaveDifferent = [&] {
    std::stable_sort(ways.begin(), ways.end());
    std::vector<Laid> different;
    for (Laid& way : ways)
      if (different.size() < MOST_WAYS &&
          std::none_of(different.begin(), different.end(), [&](const Laid& better) {
            return angleBetween(better, way) <= SAME_TURN;
          }))
        different.push_back(std::move(way));
    ways = std::move(different);
  };
  leaveDifferent();
  parallelFor(static_cast<int>(ways.size()), [&](int i) { layCloser(a, b, ways[i]); });
  leaveDifferent();
  return ways;
}

/// An end, the one that a map takes it to, and how it lies there.
struct Look {
  EndFit fit;
  End a, b;
  Laid mapped, best;  // nothing where it was not laid
};

/// \param whole_only  whether ends that are not whole are not laid either.
std::vector<Look> lookAtEnds(const SpectralSurface& a,
                             const SpectralSurface& b,
                             const std::vector<int>& tips,
                             const VertexMaps& maps,
                             bool whole_only) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  const Vector remote_a = remoteness(a), remote_b = remoteness(b);
  std::vector<char> seen(a.mesh.vertices.rows(), 0);
  std::vector<Look> looks;
  for (int tip : tips) {
    if (seen[tip]) continue;
    Look look{{tip, INFINITE, INFINITE, 0},
              endAt(a, remote_a, tip),
              endAt(b, remote_b, maps.forward[tip]),
              {},
              {}};
    for (std::size_t i = 0; i < look.a.wide.size(); ++i)
      if (look.a.inside[i]) seen[look.a.wide[i]] = 1;
    look.fit.by_chance = SAMPLING * std::max(look.a.squared_edge, look.b.squared_edge);
    const bool tells = std::min(look.a.size, look.b.size) >= FEWEST &&
                       (!whole_only || (isWhole(look.a) && isWhole(look.b)));
    if (tells) {
      look.mapped = asMapped(b, look.a, maps);
      std::vector<Laid> ways = waysToLay(look.a, look.b, look.mapped);
      look.fit.misfit = ways.front().misfit;
      if (ways.size() > 1) look.fit.next = ways[1].misfit;
      look.best = std::move(ways.front());
    }
    looks.push_back(std::move(look));
  }
  return looks;
}

/// Vertices spread over an end, the one nearest to the tip first, and what they lie next to.
std::vector<PlacePair> placesOn(
    const SpectralSurface& a, const End& end, const End& other, int tip, const Laid& laid) {
  std::vector<PlacePair> partners;
  for (const ClosestPair& pair : laid.pairs)
    partners.push_back({end.wide[pair.a], other.wide[pair.b]});
  const auto nearestTo = [&](int v) {
    const std::vector<double>& distance = a.distances.from(v);
    return std::min_element(partners.begin(),
                            partners.end(),
                            [&](const PlacePair& x, const PlacePair& y) {
                              return distance[x.a] < distance[y.a];
                            }) -
           partners.begin();
  };
  std::vector<PlacePair> places;
  Vector distance = Vector::Constant(static_cast<Eigen::Index>(partners.size()),
                                     std::numeric_limits<double>::max());
  for (Eigen::Index next = nearestTo(tip); places.size() < PLACES_ON_END;) {
    places.push_back(partners[next]);
    const std::vector<double>& from_it = a.distances.from(partners[next].a);
    for (std::size_t i = 0; i < partners.size(); ++i)
      distance[i] = std::min(distance[i], from_it[partners[i].a]);
    distance.maxCoeff(&next);
  }
  return places;
}

}  // namespace

bool EndFit::fitsInOneWay() const { return next > std::max(misfit / CLEARLY_BETTER, by_chance); }

std::vector<RigidEnd> rigidEnds(const SpectralSurface& a,
                                const SpectralSurface& b,
                                const std::vector<int>& tips,
                                const VertexMaps& maps) {
  std::vector<RigidEnd> ends;
  for (const Look& look : lookAtEnds(a, b, tips, maps, false)) {
    if (!look.fit.fitsInOneWay()) continue;
    RigidEnd end;
    for (std::size_t i = 0; i < look.a.wide.size(); ++i)
      if (look.a.inside[i]) end.vertices.push_back(look.a.wide[i]);
    end.places = placesOn(a, look.a, look.b, look.fit.tip, look.best);
    end.turned = angleBetween(look.best, look.mapped) > SAME_TURN;
    ends.push_back(std::move(end));
  }
  return ends;
}

std::vector<EndFit> fitEnds(const SpectralSurface& a,
                            const SpectralSurface& b,
                            const std::vector<int>& tips,
                            const VertexMaps& maps) {
  std::vector<EndFit> fits;
  for (const Look& look : lookAtEnds(a, b, tips, maps, true)) fits.push_back(look.fit);
  return fits;
}

std::vector<double> endDisagreements(const std::vector<std::vector<EndFit>>& fits) {
  std::vector<double> sums(fits.size(), 0);
  if (fits.empty()) return sums;
  for (const EndFit& first : fits.front()) {
    std::vector<EndFit> of_end;
    for (const std::vector<EndFit>& map : fits)
      for (const EndFit& fit : map)
        if (fit.tip == first.tip && std::isfinite(fit.misfit)) of_end.push_back(fit);
    if (of_end.size() < fits.size()) continue;
    const EndFit* best = nullptr;
    for (const EndFit& fit : of_end)
      if (fit.fitsInOneWay() && (best == nullptr || fit.misfit < best->misfit)) best = &fit;
    if (best == nullptr) continue;
    for (std::size_t k = 0; k < fits.size(); ++k) {
      const double by_chance =
          std::max({best->by_chance, of_end[k].by_chance, std::numeric_limits<double>::min()});
      const double worse = (of_end[k].misfit + by_chance) / (best->misfit + by_chance);
      sums[k] += std::log(std::clamp(worse, 1.0, DOES_NOT_FIT));
    }
  }
  return sums;
}

}  // namespace posture
