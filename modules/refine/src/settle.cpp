// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/nearest_in_triangle.h>
#include <posture/refine/settle.h>

#include <Eigen/Geometry>

#include "belief.h"
#include "pose_features.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace posture {
namespace {

constexpr int BLOCK = 256;  // vertices a thread takes at once

/// Walks each match downhill along the other surface's edges, starting from the matches the vertex
/// and its neighbours have: what one vertex has found, the next can take up.
std::vector<int> slide(const BendableSurface& from,
                       const PoseFeatures& of_from,
                       const BendableSurface& to,
                       const PoseFeatures& of_to,
                       const std::vector<int>& matches) {
  std::vector<int> better(matches.size());
  forEach(static_cast<int>(matches.size()), BLOCK, [&](int v) {
    const auto distance = [&](int t) { return (of_from.col(v) - of_to.col(t)).squaredNorm(); };
    int best = matches[v];
    float least = distance(best);
    const auto take = [&](int t) {
      const float d = distance(t);
      if (d < least || (d == least && t < best)) {
        least = d;
        best = t;
        return true;
      }
      return false;
    };
    for (const int* w = from.neighbors.begin(v); w != from.neighbors.end(v); ++w) take(matches[*w]);
    // Steps over two edges leave the small dips that a slanted triangulation makes.
    for (bool moved = true; moved;) {
      moved = false;
      const int here = best;
      const int* const end = to.within_two_edges.end(here);
      for (const int* w = to.within_two_edges.begin(here); w != end; ++w) moved |= take(*w);
    }
    better[v] = best;
  });
  return better;
}

/// Where each vertex of one surface fits best in the faces around its match on the other.
std::vector<FacePoint> bestPlaces(const PoseFeatures& of_from,
                                  const BendableSurface& to,
                                  const PoseFeatures& of_to,
                                  const std::vector<int>& matches) {
  std::vector<FacePoint> places(matches.size());
  forEach(static_cast<int>(matches.size()), BLOCK, [&](int v) {
    using Column = Eigen::Matrix<float, 12, 1>;
    const int match = matches[v];
    const Column corner = of_to.col(match), to_point = of_from.col(v) - corner;
    float least = std::numeric_limits<float>::infinity();
    const VertexFaces& around = to.faces_around;
    for (const int* f = around.begin(match); f != around.end(match); ++f) {
      const auto face = to.mesh.faces.row(*f);
      const int first = face[0] == match ? 0 : face[1] == match ? 1 : 2;
      const int second = (first + 1) % 3, third = (first + 2) % 3;
      const Column to_second = of_to.col(face[second]) - corner,
                   to_third = of_to.col(face[third]) - corner;
      const Eigen::Vector3d at = nearestInTriangle({to_second.squaredNorm(),
                                                    to_second.dot(to_third),
                                                    to_third.squaredNorm(),
                                                    to_second.dot(to_point),
                                                    to_third.dot(to_point)});
      const float distance =
          (static_cast<float>(at[1]) * to_second + static_cast<float>(at[2]) * to_third - to_point)
              .squaredNorm();
      if (!(distance < least || places[v].face < 0)) continue;  // a face even of what is no number
      least = distance;
      places[v].face = *f;
      places[v].barycentric[first] = at[0];
      places[v].barycentric[second] = at[1];
      places[v].barycentric[third] = at[2];
    }
  });
  return places;
}

Points pointsAt(const std::vector<FacePoint>& places, const TriangleMesh& mesh) {
  Points points = Points::Zero(static_cast<Eigen::Index>(places.size()), 3);
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const FacePoint& place = places[v];
    for (int k = 0; k < 3; ++k)
      points.row(v) += place.barycentric[k] * mesh.vertices.row(mesh.faces(place.face, k));
  }
  return points;
}

/// How often it is looked anew where a surface is strained and which matches are believed.
constexpr int RENEWAL = 3;

/// Shares of the softness in anneal(). Many of few rounds do no worse than few of many, and by up
/// to 5 % better.
constexpr std::array<double, 7> ANNEALING{0.1, 0.17, 0.3, 0.55, 1, 1.7, 1};
constexpr int ROUNDS_OF_A_SHARE = 6;

/// How places are pulled in a round: towards goals `overshoot` times as far off as they are, after
/// having moved on by `momentum` of how far they came in the round before.
struct Stride {
  double overshoot, momentum;
};
constexpr Stride TO_THE_GOAL{1, 0};

/// Slides faster: momentum is the heavy ball method's (Polyak 1964), which from 1 on never comes to
/// rest. Where surfaces resist, goals farther off are like a higher softness; going 1.8 times as
/// far as the whole pull leads (successive over-relaxation) diverges with this momentum.
constexpr Stride FAST{1.8, 0.8};

/// Bends one surface further and further onto another one.
class Bender {
 public:
  /// \param apart  vertices of the one that is bent whose matches do not count.
  Bender(const BendableSurface& from,
         const BendableSurface& to,
         const std::vector<char>& apart,
         const Stride& stride)
      : from_(from), to_(to), apart_(apart), stride_(stride) {}

  void soften(double softness) {
    softness_ = softness;
    pulls_ = 0;
  }

  /// Goals are places in faces: those of vertices are off by up to half an edge.
  void pull(const PoseFeatures& of_from,
            const PoseFeatures& of_to,
            const std::vector<int>& matches,
            Points& bent) {
    if (pulls_++ % RENEWAL == 0)
      attraction_ = from_.arap.attract(softness_, belief(from_, to_, matches, apart_), bent);
    const Points goals = pointsAt(bestPlaces(of_from, to_, of_to, matches), to_.mesh);
    if (before_.rows() == 0) before_ = bent;
    const Points start = bent + stride_.momentum * (bent - before_);
    before_ = std::move(bent);
    bent = from_.arap.pull(
        start, start + stride_.overshoot * (goals - before_), *attraction_, BENDING_STEPS);
  }

 private:
  const BendableSurface &from_, &to_;
  const std::vector<char>& apart_;
  Stride stride_;
  double softness_ = 0;
  int pulls_ = 0;
  Points before_;
  std::optional<Arap::Attraction> attraction_;
};

/// Lets the surfaces of a pair slide on each other, both ways at once.
class Settling {
 public:
  Settling(const BendableSurface& a, const BendableSurface& b, const Stride& stride, BentPair& pair)
      : a_(a),
        b_(b),
        pair_(pair),
        bend_a_(a, b, pair.apart_a, stride),
        bend_b_(b, a, pair.apart_b, stride) {}

  void run(double softness, int rounds) {
    bend_a_.soften(softness);
    bend_b_.soften(softness);
    PoseFeaturePair of = poseFeatures(a_, b_, softness, pair_);
    for (int round = 0; round < rounds; ++round) {
      inParallel([&] { bend_a_.pull(of.a, of.b, pair_.maps.forward, pair_.bent_a); },
                 [&] { bend_b_.pull(of.b, of.a, pair_.maps.backward, pair_.bent_b); });
      of = poseFeatures(a_, b_, softness, pair_);
      pair_.maps = {slide(a_, of.a, b_, of.b, pair_.maps.forward),
                    slide(b_, of.b, a_, of.a, pair_.maps.backward)};
    }
  }

 private:
  const BendableSurface &a_, &b_;
  BentPair& pair_;
  Bender bend_a_, bend_b_;
};

}  // namespace

double settlingSoftness(const Vector& eigenvalues_a, const Vector& eigenvalues_b) {
  const auto k = std::min(eigenvalues_a.size(), eigenvalues_b.size());
  return 0.5 * (eigenvalues_a[k - 1] + eigenvalues_b[k - 1]);
}

double settlingSoftness(const SpectralSurface& a, const SpectralSurface& b) {
  return settlingSoftness(a.eigenvalues, b.eigenvalues);
}

void settle(const BendableSurface& a,
            const BendableSurface& b,
            double softness,
            int rounds,
            BentPair& pair) {
  Settling(a, b, TO_THE_GOAL, pair).run(softness, rounds);
}

void settleSoftening(const BendableSurface& a,
                     const BendableSurface& b,
                     double softness,
                     BentPair& pair,
                     std::size_t first) {
  for (std::size_t k = first; k < SETTLING.size(); ++k)
    settle(a, b, SETTLING[k] * softness, SETTLING_ROUNDS, pair);
}

void polish(const BendableSurface& a,
            const BendableSurface& b,
            double softness,
            int rounds,
            BentPair& pair) {
  Settling(a, b, FAST, pair).run(softness, rounds);
}

void anneal(const BendableSurface& a, const BendableSurface& b, double softness, BentPair& pair) {
  Settling settling(a, b, FAST, pair);
  for (double share : ANNEALING) settling.run(share * softness, ROUNDS_OF_A_SHARE);
}

std::vector<FacePoint> placesOnFaces(const BendableSurface& a,
                                     const BendableSurface& b,
                                     double softness,
                                     const BentPair& pair) {
  const PoseFeaturePair of = poseFeatures(a, b, softness, pair);
  return bestPlaces(of.a, b, of.b, pair.maps.forward);
}

}  // namespace posture
