// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>
#include <posture/refine/grow_anew.h>
#include <posture/refine/partners.h>
#include <posture/refine/settle.h>

#include <gtest/gtest.h>

#include "refine/poses.h"
#include <algorithm>
#include <functional>
#include <vector>

namespace posture {
namespace {

using Place = Eigen::RowVector3d;

/// A body, or what is left of it, with where its vertices are at rest.
struct Figure {
  SpectralSurface surface;  ///< of an area of one
  Points given;             ///< its vertices as they came
  Points rest;

  bool isOnLeftArm(int v) const { return rest(v, 0) > ARM; }
  bool isOnRightArm(int v) const { return rest(v, 0) < -ARM; }

  static constexpr double ARM = 0.14;  ///< from the middle on: arms without their shoulders
};

/// Without the vertices that are `gone`; the first of the others are spread evenly.
Figure figure(const ArticulatedBody& body, const std::function<bool(const Place&)>& gone) {
  const TriangleMesh& mesh = body.mesh;
  const int n = static_cast<int>(mesh.vertices.rows());
  std::vector<int> faces, order;
  std::vector<char> used(n, 0);
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const auto face = mesh.faces.row(f);
    if (std::any_of(
            face.begin(), face.end(), [&](int v) { return gone(body.rest_position.row(v)); }))
      continue;
    faces.push_back(f);
    for (int v : face) used[v] = 1;
  }
  const auto take = [&](int v) {
    if (used[v] != 0) order.push_back(v);
    used[v] = 0;
  };
  for (int v : voronoiSamples(mesh, FastMarching(mesh)).vertices) take(v);
  for (int v = 0; v < n; ++v) take(v);
  std::vector<int> number(n, -1);
  for (std::size_t i = 0; i < order.size(); ++i) number[order[i]] = static_cast<int>(i);
  TriangleMesh part{mesh.vertices(order, Eigen::all), mesh.faces(faces, Eigen::all)};
  for (int& v : part.faces.reshaped()) v = number[v];
  const Points given = part.vertices;
  return {test::spectralSurface(std::move(part), 150),
          given,
          Points(body.rest_position(order, Eigen::all))};
}

bool nothing(const Place&) { return false; }
bool nobody(int) { return false; }

/// Where `a`'s vertices go on `b`, the places at rest of some of them exchanged.
std::vector<int> mapOf(const Figure& a,
                       const Figure& b,
                       const std::function<Place(const Place&)>& taken_for) {
  const PointIndex index(b.rest);
  std::vector<int> map;
  for (const auto& place : a.rest.rowwise())
    map.push_back(index.nearest(taken_for(place).transpose()).index);
  return map;
}

/// Both surfaces as they come to lie under the two maps.
BentPair settled(const Figure& a,
                 const Figure& b,
                 double softness,
                 const std::function<Place(const Place&)>& taken_for) {
  const VertexMaps maps{mapOf(a, b, taken_for), mapOf(b, a, taken_for)};
  BentPair pair{maps,
                b.surface.mesh.vertices(maps.forward, Eigen::all),
                a.surface.mesh.vertices(maps.backward, Eigen::all)};
  for (double share : {0.1, 0.3, 1.0}) settle(a.surface, b.surface, share * softness, 6, pair);
  return pair;
}

/// How far off the matches are at rest, in edges, of the vertices that have a counterpart and are
/// not left out.
double meanMiss(const Figure& a,
                const Figure& b,
                const BentPair& pair,
                const std::function<bool(int)>& left_out) {
  const std::vector<char> without = withoutPartner(a.surface, b.surface, pair, {});
  double sum = 0;
  int count = 0;
  for (int v = 0; v < a.rest.rows(); ++v)
    if (without[v] == 0 && !left_out(v)) {
      sum += (a.rest.row(v) - b.rest.row(pair.maps.forward[v])).norm();
      ++count;
    }
  return sum / (count * meanEdgeLength({b.rest, b.surface.mesh.faces}));
}

const ScoredPair& best(const std::vector<ScoredPair>& grown) {
  return *std::min_element(grown.begin(), grown.end(), [](const auto& x, const auto& y) {
    return x.score.total() < y.score.total();
  });
}

double softnessOf(const Figure& a) {
  return a.surface.eigenvalues[a.surface.eigenvalues.size() - 1];
}

TEST(GrowAnew, anArmThatLiesOnTheOtherOneGoesWithItsShoulder) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const Figure a = figure(poses.body_a, [](const Place&p) { return p.x() < -Figure::ARM; }),
               b = figure(poses.body_b, [](const Place&p) { return p.x() > Figure::ARM; });
  // The one arm of the one on the one arm of the other.
  const auto taken_for = [](const Place& p) {
    return std::abs(p.x()) > Figure::ARM ? Place(-p.x(), p.y(), p.z()) : p;
  };
  const auto onTheArm = [&](int v) { return a.isOnLeftArm(v); };
  const auto shareOfArm = [&](const std::function<bool(int)>& is) {
    int arm = 0, those = 0;
    for (int v = 0; v < a.rest.rows(); ++v)
      if (onTheArm(v)) {
        ++arm;
        those += is(v);
      }
    return static_cast<double>(those) / arm;
  };
  const double softness = softnessOf(a);
  const BentPair wrong = settled(a, b, softness, taken_for);
  ASSERT_GT(shareOfArm([&](int v) { return b.isOnRightArm(wrong.maps.forward[v]); }), 0.9);

  const std::vector<ScoredPair> grown = growAnew(a.surface, b.surface, softness, wrong, wrong);
  const BentPair& pair = best(grown).pair;
  EXPECT_LT(best(grown).score.total(), scoreBent(a.surface, b.surface, wrong, false).total());
  const std::vector<char> without = withoutPartner(a.surface, b.surface, pair, {});
  EXPECT_GT(shareOfArm([&](int v) { return without[v] != 0; }), 0.8);
  EXPECT_LT(meanMiss(a, b, pair, onTheArm), 1);
  std::vector<char> arm;
  for (int v = 0; v < a.rest.rows(); ++v) arm.push_back(onTheArm(v));
  EXPECT_LT(best(grown).score.let_go, areaShare(a.surface, arm) + 0.03);
  // It is not raised as in the other pose, but it hangs from the left shoulder.
  const ArticulatedBody& whole = poses.body_b;
  const PointIndex index(whole.rest_position);
  const double scale = b.surface.mesh.vertices.norm() / b.given.norm();
  double off = 0;
  for (int v = 0; v < a.rest.rows(); ++v)
    if (onTheArm(v) && a.rest(v, 0) < Figure::ARM + 0.02) {
      const Place there = whole.mesh.vertices.row(index.nearest(a.rest.row(v).transpose()).index);
      off = std::max(off, (pair.bent_a.row(v) - scale * there).norm());
    }
  EXPECT_LT(off, 0.2);
}

TEST(GrowAnew, aTrunkWoundByHalfATurnGrowsFromTheLegs) {
  constexpr double WAIST = 0.6;
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const Figure a = figure(poses.body_a, nothing), b = figure(poses.body_b, nothing);
  const auto taken_for = [](const Place& p) {
    return p.z() > WAIST ? Place(-p.x(), -p.y(), p.z()) : p;
  };
  const auto below = [&](int v) { return a.rest(v, 2) < WAIST; };
  const double softness = softnessOf(a);
  const BentPair wrong = settled(a, b, softness, taken_for);
  ASSERT_GT(meanMiss(a, b, wrong, below), 4);

  const std::vector<ScoredPair> grown = growAnew(a.surface, b.surface, softness, wrong, wrong);
  EXPECT_LT(best(grown).score.total(), scoreBent(a.surface, b.surface, wrong, false).total());
  EXPECT_LT(meanMiss(a, b, best(grown).pair, nobody), 1);
  EXPECT_LT(best(grown).score.let_go, 0.25);  // the arms, which are raised in the other pose
}

TEST(GrowAnew, whatIsRightGrowsBackToWhereItWas) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const Figure a = figure(poses.body_a, nothing), b = figure(poses.body_b, nothing);
  const double softness = softnessOf(a);
  const BentPair right = settled(a, b, softness, [](const Place& p) { return p; });
  const std::vector<ScoredPair> all = growAnew(a.surface, b.surface, softness, right, right);
  ASSERT_GT(all.size(), 4U);
  const double before = meanMiss(a, b, right, nobody);
  const auto isBack = [&](const ScoredPair& one) {
    return one.score.let_go < 0.02 && meanMiss(a, b, one.pair, nobody) < before + 0.1;
  };
  EXPECT_GT(std::count_if(all.begin(), all.end(), isBack),
            static_cast<std::ptrdiff_t>(all.size()) / 2);
}

TEST(GrowAnew, whatIsApartIsNotKept) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const Figure a = figure(poses.body_a, nothing), b = figure(poses.body_b, nothing);
  const double softness = softnessOf(a);
  BentPair pair = settled(a, b, softness, [](const Place& p) { return p; });
  pair.apart_a.assign(a.rest.rows(), 1);
  pair.apart_b.assign(b.rest.rows(), 1);
  EXPECT_TRUE(growAnew(a.surface, b.surface, softness, pair, pair).empty());
}

}  // namespace
}  // namespace posture
