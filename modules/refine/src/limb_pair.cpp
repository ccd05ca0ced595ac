// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "limb_pair.h"

#include <posture/core/compact_vertices.h>
#include <posture/core/parallel.h>
#include <posture/mesh/normals.h>
#include <posture/refine/settle.h>

#include <Eigen/Geometry>

#include "belief.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace posture {
namespace {

/// What has more of the surface within reach is no limb.
constexpr double LARGEST_SHARE = 0.4;

/// Of each of SETTLING, where a limb settles for a short while.
constexpr int ROUNDS = 4;

/// Normals count so much more while the surfaces do not lie on each other yet.
constexpr double FIRST_NORMAL_WEIGHT = 10;

constexpr std::size_t FEWEST = 20;  ///< vertices of a limb

/// The middle of a limb as it lies, from the tip on.
class Spine {
 public:
  Spine(const Points& places, const std::vector<double>& distance, const Vector& mass, double reach)
      : middle_(static_cast<std::size_t>(std::lround(reach / STEP)), Eigen::Vector3d::Zero()) {
    std::vector<double> weight(middle_.size(), 0);
    for (int v = 0; v < places.rows(); ++v) {
      const int level = std::min(levels() - 1, static_cast<int>(distance[v] / STEP));
      middle_[level] += mass[v] * places.row(v).transpose();
      weight[level] += mass[v];
    }
    for (int i = 0; i < levels(); ++i)
      if (weight[i] > 0)
        middle_[i] /= weight[i];
      else
        is_whole_ = false;
  }

  /// Whether the mesh is fine enough to have vertices all along it; otherwise there is no turning.
  bool isWhole() const { return is_whole_; }

  /// About the limb, at a distance from its tip.
  Eigen::Isometry3d turn(double distance, double angle) const {
    const Eigen::Vector3d middle = at(distance),
                          along = at(distance - 1.5 * STEP) - at(distance + 1.5 * STEP);
    if (!(along.norm() > 0)) return Eigen::Isometry3d::Identity();
    return Eigen::Translation3d(middle) * Eigen::AngleAxisd(angle, along.normalized()) *
           Eigen::Translation3d(-middle);
  }

 private:
  static constexpr double STEP = 0.05;

  int levels() const { return static_cast<int>(middle_.size()); }
  Eigen::Vector3d at(double distance) const {
    const double x = std::clamp(distance / STEP - 0.5, 0.0, levels() - 1.0);
    const int i = std::min(static_cast<int>(x), levels() - 2);
    return middle_[i] + (x - i) * (middle_[i + 1] - middle_[i]);
  }

  std::vector<Eigen::Vector3d> middle_;
  bool is_whole_ = true;
};

Spine spineOf(const Limb& limb, const Lie& lie) {
  return {lie.places, limb.distance, limb.surface->laplacian.mass, limb.reach};
}

/// How much of the end's motion a place makes: all up to `end`, nothing from `body` on.
double shareAt(double distance, double end, double body) {
  return std::clamp((body - distance) / (body - end), 0.0, 1.0);
}

/// \param motion_at  of a distance from the tip.
template <class MotionAt>
Lie moved(const Limb& limb, Lie lie, double body, const MotionAt& motion_at) {
  for (int v = 0; v < lie.places.rows(); ++v) {
    if (limb.distance[v] >= body) continue;
    const Eigen::Isometry3d motion = motion_at(limb.distance[v]);
    lie.places.row(v) = (motion * Eigen::Vector3d(lie.places.row(v))).transpose();
    lie.normals.row(v) = lie.normals.row(v) * motion.linear().transpose();
  }
  return lie;
}

Lie turned(const Limb& limb, const Lie& lie, const LimbTurn& turn, double sign) {
  if (turn.angle == 0) return lie;
  const Spine spine = spineOf(limb, lie);
  return moved(limb, lie, turn.body, [&](double distance) {
    return spine.turn(distance, sign * shareAt(distance, turn.end, turn.body) * turn.angle);
  });
}

/// \param motion  of the end.
Lie endMoved(const Limb& limb,
             const Lie& lie,
             const Eigen::Isometry3d& motion,
             const EndMove& move) {
  std::vector<int> end;
  for (std::size_t v = 0; v < limb.distance.size(); ++v)
    if (limb.distance[v] <= move.end) end.push_back(static_cast<int>(v));
  if (end.empty()) return lie;
  const Eigen::Vector3d middle = lie.places(end, Eigen::all).colwise().mean().transpose(),
                        shift = motion * middle - middle;
  const Eigen::AngleAxisd turn(motion.linear());
  return moved(limb, lie, move.body, [&](double distance) {
    const double share = shareAt(distance, move.end, move.body);
    return Eigen::Translation3d(middle + share * shift) *
           Eigen::AngleAxisd(share * turn.angle(), turn.axis()) * Eigen::Translation3d(-middle);
  });
}

std::vector<int> nearest(const Lie& from, const BendableSurface& to, double normal_sq) {
  std::vector<int> best(from.places.rows());
  for (int v = 0; v < from.places.rows(); ++v) {
    Eigen::Index i = 0;
    ((to.mesh.vertices.rowwise() - from.places.row(v)).rowwise().squaredNorm() +
     normal_sq * (to.normals.rowwise() - from.normals.row(v)).rowwise().squaredNorm())
        .minCoeff(&i);
    best[v] = static_cast<int>(i);
  }
  return best;
}

bool isSmall(const Limb& limb, const SpectralSurface& whole) {
  return limb.surface &&
         limb.surface->laplacian.mass.sum() <= LARGEST_SHARE * whole.laplacian.mass.sum();
}

Lie lieOf(const Limb& limb, const Points& bent) {
  const Points places = bent(limb.vertex, Eigen::all);
  return {places, vertexNormals({places, limb.surface->mesh.faces})};
}

/// Of each vertex of the whole surface, those of the limb.
std::vector<char> ofLimb(const Limb& limb, const std::vector<char>& apart) {
  std::vector<char> of_limb;
  if (apart.empty()) return of_limb;
  for (int v : limb.vertex) of_limb.push_back(apart[v]);
  return of_limb;
}

double misfitOfAll(const BendableSurface& a,
                   const BendableSurface& b,
                   double softness,
                   const BentPair& pair) {
  std::vector<int> all(a.mesh.vertices.rows());
  std::iota(all.begin(), all.end(), 0);
  return oneWayMisfit(a, {all, a.arap}, b, softness, pair);
}

}  // namespace

Limb limbAt(const SpectralSurface& whole, int tip, double reach) {
  const TriangleMesh& mesh = whole.mesh;
  const std::vector<double>& distance = whole.distances.from(tip);
  std::vector<int> faces;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const auto face = mesh.faces.row(f);
    if (std::all_of(face.begin(), face.end(), [&](int v) { return distance[v] <= reach; }))
      faces.push_back(f);
  }
  TriangleMesh part{{}, mesh.faces(faces, Eigen::all)};
  std::vector<int> vertex = compactVertices(part.faces, static_cast<int>(mesh.vertices.rows()));
  if (vertex.size() < FEWEST) return {};
  part.vertices = mesh.vertices(vertex, Eigen::all);
  std::vector<double> far;
  far.reserve(vertex.size());
  for (int v : vertex) far.push_back(distance[v]);
  return {std::move(vertex), std::move(far), reach, BendableSurface(std::move(part))};
}

double oneWayGap(const BendableSurface& a,
                 const std::vector<int>& vertices,
                 const BendableSurface& b,
                 double softness,
                 const BentPair& pair) {
  const std::vector<int>& matches = pair.maps.forward;
  const Vector weight = a.laplacian.mass.cwiseProduct(belief(a, b, matches, pair.apart_a));
  const double sum = weight(vertices).sum();
  if (!(sum > 0)) return std::numeric_limits<double>::infinity();
  const Points normals_a = vertexNormals({pair.bent_a, a.mesh.faces}),
               normals_b = vertexNormals({pair.bent_b, b.mesh.faces});
  double off = 0;
  for (int v : vertices) {
    const int m = matches[v];
    off += weight[v] * (softness * ((pair.bent_a.row(v) - b.mesh.vertices.row(m)).squaredNorm() +
                                    (a.mesh.vertices.row(v) - pair.bent_b.row(m)).squaredNorm()) +
                        (normals_a.row(v) - b.normals.row(m)).squaredNorm() +
                        (a.normals.row(v) - normals_b.row(m)).squaredNorm());
  }
  return off / sum;
}

double oneWayMisfit(const BendableSurface& a,
                    const Part& part,
                    const BendableSurface& b,
                    double softness,
                    const BentPair& pair) {
  return part.arap.energy(pair.bent_a(part.vertex, Eigen::all)) +
         oneWayGap(a, part.vertex, b, softness, pair);
}

LimbPair::LimbPair(const SpectralSurface& a,
                   const SpectralSurface& b,
                   int tip,
                   double reach,
                   double softness,
                   const BentPair& pair)
    : a_(limbAt(a, tip, reach)),
      b_(limbAt(b, pair.maps.forward[tip], reach)),
      is_limb_(isSmall(a_, a) && isSmall(b_, b)),
      softness_(softness) {
  if (!is_limb_) return;
  lie_a_ = lieOf(a_, pair.bent_a);
  lie_b_ = lieOf(b_, pair.bent_b);
  apart_a_ = ofLimb(a_, pair.apart_a);
  apart_b_ = ofLimb(b_, pair.apart_b);
  is_limb_ = spineOf(a_, lie_a_).isWhole() && spineOf(b_, lie_b_).isWhole();
}

BentPair LimbPair::laid(const LimbTurn& turn) const {
  return matched(turned(a_, lie_a_, turn, 1), turned(b_, lie_b_, turn, -1));
}

BentPair LimbPair::matched(const Lie& a, const Lie& b) const {
  const double normal_sq = FIRST_NORMAL_WEIGHT / softness_;
  return {{nearest(a, *b_.surface, normal_sq), nearest(b, *a_.surface, normal_sq)},
          a.places,
          b.places,
          apart_a_,
          apart_b_};
}

BentPair LimbPair::settled(const LimbTurn& turn) const {
  BentPair pair = laid(turn);
  for (double share : SETTLING) settle(*a_.surface, *b_.surface, share * softness_, ROUNDS, pair);
  return pair;
}

BentPair LimbPair::annealed(const LimbTurn& turn) const { return annealed(laid(turn)); }

BentPair LimbPair::annealed(const EndMove& move) const {
  return annealed(
      matched(endMoved(a_, lie_a_, move.of_a, move), endMoved(b_, lie_b_, move.of_b, move)));
}

BentPair LimbPair::annealed(BentPair pair) const {
  anneal(*a_.surface, *b_.surface, softness_, pair);
  return pair;
}

double LimbPair::misfit(const BentPair& pair) const {
  return misfitOfAll(*a_.surface, *b_.surface, softness_, pair) +
         misfitOfAll(*b_.surface, *a_.surface, softness_, reversed(pair));
}

void LimbPair::putInto(const BentPair& limb, BentPair& whole) const {
  for (std::size_t v = 0; v < a_.vertex.size(); ++v) {
    whole.maps.forward[a_.vertex[v]] = b_.vertex[limb.maps.forward[v]];
    whole.bent_a.row(a_.vertex[v]) = limb.bent_a.row(static_cast<int>(v));
  }
  for (std::size_t v = 0; v < b_.vertex.size(); ++v) {
    whole.maps.backward[b_.vertex[v]] = a_.vertex[limb.maps.backward[v]];
    whole.bent_b.row(b_.vertex[v]) = limb.bent_b.row(static_cast<int>(v));
  }
}

std::vector<Trial> trials(const LimbPair& limb, const std::vector<LimbTurn>& turns) {
  std::vector<Trial> tried(turns.size() + 1);
  parallelFor(static_cast<int>(tried.size()), [&](int k) {
    Trial& trial = tried[k];
    if (k > 0) trial.turn = turns[k - 1];
    try {
      trial.limb = limb.settled(trial.turn);
      trial.misfit = limb.misfit(trial.limb);
    } catch (const TornSurface&) {  // a crumb of the limb that nothing holds
      trial.misfit = std::numeric_limits<double>::infinity();
    }
  });
  const double unturned = tried.front().misfit;
  tried.erase(tried.begin());
  for (Trial& trial : tried) {
    trial.misfit /= unturned;
    if (!std::isfinite(unturned) || !std::isfinite(trial.misfit))
      trial.misfit = std::numeric_limits<double>::infinity();
  }
  std::stable_sort(tried.begin(), tried.end(), [](const Trial& x, const Trial& y) {
    return x.misfit < y.misfit;
  });
  return tried;
}

}  // namespace posture
