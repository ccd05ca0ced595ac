// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/refine/rigid_ends.h>

#include <Eigen/Geometry>

#include "even_rotations.h"
#include "joint_nearest.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace posture {
namespace {

/// Lengths in square roots of the area. Ears and nose lie so far from each other.
constexpr double TIP_REACH = 0.25;

/// An end: a head, a hand, a foot; and by how much more of the other surface it may lie on.
constexpr double END = 0.1, MARGIN = 0.1;

/// Vertices of an end that tell a motion.
constexpr std::size_t FEWEST = 20;

/// Places from which the mean distance is taken.
constexpr int PLACES = 80;

/// A normal turned by 90 degrees counts as much as a distance of 0.07.
constexpr float NORMAL_LENGTH = 0.05f;

/// Of the distances the largest fifth does not count: what lies at the cut.
constexpr double TRIMMED = 0.8;

constexpr int TURNS = 72, STEPS = 20;

/// Motions that turn by less from each other are one.
constexpr double SAME_TURN = M_PI / 6;

/// Of the misfit in the next best way, or in that of the map: a head that fits has 0.2 to 0.4,
/// other ends 0.6 and more.
constexpr double CLEARLY_BETTER = 0.5;

constexpr std::size_t LANDMARKS = 5;

/// Mean geodesic distance from places all over the surface. The first vertices are spread evenly.
Vector remoteness(const SpectralSurface& surface) {
  const int n = static_cast<int>(surface.mesh.vertices.rows()), places = std::min(PLACES, n);
  Vector sum = Vector::Zero(n);
  for (int i = 0; i < places; ++i)
    sum += Eigen::Map<const Vector>(surface.distances.from(i).data(), n);
  return sum / places;
}

/// The end of a limb and what is around it.
struct End {
  std::vector<int> wide;     // vertices within END + MARGIN
  std::vector<char> inside;  // for each of them, whether it is within END
  Points places, normals;    // of `wide`
  std::size_t size = 0;      // of the end
};

End endAt(const SpectralSurface& surface, const Vector& remote, int tip) {
  const std::vector<double>& from_tip = surface.distances.from(tip);
  std::vector<int> extremes{tip};
  for (int v = 0; v < remote.size(); ++v) {
    const VertexNeighbors& near = surface.within_two_edges;
    if (from_tip[v] < TIP_REACH &&
        std::all_of(near.begin(v), near.end(v), [&](int w) { return remote[w] <= remote[v]; }))
      extremes.push_back(v);
  }
  std::vector<double> distance = from_tip;
  for (int extreme : extremes) {
    const std::vector<double>& from_it = surface.distances.from(extreme);
    for (std::size_t v = 0; v < distance.size(); ++v)
      distance[v] = std::min(distance[v], from_it[v]);
  }
  End end;
  for (int v = 0; v < remote.size(); ++v) {
    if (!(distance[v] < END + MARGIN)) continue;
    end.wide.push_back(v);
    end.inside.push_back(distance[v] < END);
    if (end.inside.back()) ++end.size;
  }
  end.places = surface.mesh.vertices(end.wide, Eigen::all);
  end.normals = surface.normals(end.wide, Eigen::all);
  return end;
}

/// Rows of two ends that lie next to each other.
struct Pairing {
  int a, b;
  float squared;
};

/// An end laid on another one.
struct Laid {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  double misfit = std::numeric_limits<double>::infinity();

  bool operator<(const Laid& other) const { return misfit < other.misfit; }
};

double angleBetween(const Laid& x, const Laid& y) {
  return Eigen::AngleAxisd(x.motion.linear() * y.motion.linear().transpose()).angle();
}

class EndPair {
 public:
  EndPair(const End& a, const End& b) : a_(a), b_(b), of_b_(b.places.rows(), 6) {
    of_b_ << b.places.cast<float>(), NORMAL_LENGTH * b.normals.cast<float>();
  }

  void layCloser(Laid& laid) const {
    for (int step = 0; step < STEPS; ++step) {
      const std::vector<Pairing> pairs = nearestPairs(laid.motion);
      Points from(pairs.size(), 3), to(pairs.size(), 3);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        from.row(i) = a_.places.row(pairs[i].a);
        to.row(i) = b_.places.row(pairs[i].b);
      }
      laid.motion = rigidMotion(from, to);
    }
    laid.misfit = misfit(laid.motion);
  }

  double misfit(const Eigen::Isometry3d& motion) const {
    double sum = 0;
    const std::vector<Pairing> pairs = nearestPairs(motion);
    for (const Pairing& pair : pairs) sum += pair.squared;
    return sum / static_cast<double>(pairs.size());
  }

 private:
  /// What each vertex of either end is next to around the other one, without the farthest.
  std::vector<Pairing> nearestPairs(const Eigen::Isometry3d& motion) const {
    Eigen::MatrixXf of_a(a_.places.rows(), 6);
    const Points places =
        (a_.places * motion.linear().transpose()).rowwise() + motion.translation().transpose();
    const Points normals = a_.normals * motion.linear().transpose();
    of_a << places.cast<float>(), NORMAL_LENGTH * normals.cast<float>();
    std::vector<int> forward, backward;
    nearestBothWays(of_a, of_b_, forward, backward);
    std::vector<Pairing> pairs;
    const auto add = [&](int i, int j) {
      pairs.push_back({i, j, (of_a.row(i) - of_b_.row(j)).squaredNorm()});
    };
    for (std::size_t i = 0; i < forward.size(); ++i)
      if (a_.inside[i]) add(static_cast<int>(i), forward[i]);
    for (std::size_t j = 0; j < backward.size(); ++j)
      if (b_.inside[j]) add(backward[j], static_cast<int>(j));
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pairing& x, const Pairing& y) {
      return x.squared < y.squared;
    });
    pairs.resize(static_cast<std::size_t>(TRIMMED * static_cast<double>(pairs.size())));
    return pairs;
  }

  const End &a_, &b_;
  Eigen::MatrixXf of_b_;
};

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

/// The way that fits clearly better than all others.
std::optional<Laid> onlyWay(const EndPair& pair, const End& a, const End& b, const Laid& mapped) {
  const std::vector<Eigen::Matrix3d> turns = evenRotations(TURNS);
  const Eigen::Vector3d middle_a = middleOf(a), middle_b = middleOf(b);
  std::vector<Laid> ways(turns.size());
  parallelFor(static_cast<int>(ways.size()), [&](int i) {
    ways[i].motion.linear() = turns[i] * mapped.motion.linear();
    ways[i].motion.translation() = middle_b - ways[i].motion.linear() * middle_a;
    pair.layCloser(ways[i]);
  });
  const Laid& best = *std::min_element(ways.begin(), ways.end());
  for (const Laid& way : ways)
    if (angleBetween(best, way) > SAME_TURN && !(best.misfit < CLEARLY_BETTER * way.misfit))
      return std::nullopt;
  return best;
}

/// Vertices of an end spread over it, and where the motion takes them.
std::vector<Landmark> landmarksOn(
    const SpectralSurface& a, const End& end, const End& other, int tip, const Laid& laid) {
  std::vector<Landmark> landmarks;
  Vector distance = Vector::Constant(static_cast<Eigen::Index>(end.wide.size()), 1e9);
  for (std::size_t i = 0; i < end.wide.size(); ++i)
    if (!end.inside[i]) distance[i] = 0;
  for (int next = tip; landmarks.size() < LANDMARKS;) {
    const Eigen::RowVector3d goal =
        (laid.motion * Eigen::Vector3d(a.mesh.vertices.row(next))).transpose();
    Eigen::Index nearest = 0, farthest = 0;
    (other.places.rowwise() - goal).rowwise().squaredNorm().minCoeff(&nearest);
    landmarks.push_back({next, other.wide[nearest]});
    const std::vector<double>& from_it = a.distances.from(next);
    for (std::size_t i = 0; i < end.wide.size(); ++i)
      distance[i] = std::min(distance[i], from_it[end.wide[i]]);
    distance.maxCoeff(&farthest);
    next = end.wide[farthest];
  }
  return landmarks;
}

}  // namespace

std::vector<RigidEnd> rigidEnds(const SpectralSurface& a,
                                const SpectralSurface& b,
                                const std::vector<int>& tips,
                                const VertexMaps& maps) {
  const Vector remote_a = remoteness(a), remote_b = remoteness(b);
  std::vector<char> seen(a.mesh.vertices.rows(), 0);
  std::vector<RigidEnd> ends;
  for (int tip : tips) {
    if (seen[tip]) continue;
    const End of_a = endAt(a, remote_a, tip), of_b = endAt(b, remote_b, maps.forward[tip]);
    RigidEnd end;
    for (std::size_t i = 0; i < of_a.wide.size(); ++i)
      if (of_a.inside[i]) end.vertices.push_back(of_a.wide[i]);
    for (int v : end.vertices) seen[v] = 1;
    if (std::min(of_a.size, of_b.size) < FEWEST) continue;
    const EndPair pair(of_a, of_b);
    Laid mapped = asMapped(b, of_a, maps);
    mapped.misfit = pair.misfit(mapped.motion);
    const std::optional<Laid> best = onlyWay(pair, of_a, of_b, mapped);
    if (!best) continue;
    end.landmarks = landmarksOn(a, of_a, of_b, tip, *best);
    end.turned =
        angleBetween(*best, mapped) > SAME_TURN && best->misfit < CLEARLY_BETTER * mapped.misfit;
    ends.push_back(std::move(end));
  }
  return ends;
}

}  // namespace posture
