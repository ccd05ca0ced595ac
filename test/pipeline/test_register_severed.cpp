// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/hole_patches.h>
#include <posture/pipeline/register_shapes.h>

#include <gtest/gtest.h>

#include "support/bodies.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace posture {
namespace {

using test::person;

/// A person without what lies between two distances from the plane of symmetry, along one arm: the
/// hand is a piece of its own, or gone. \param side  1: the left arm, -1: the right one.
struct Severed {
  Severed(const ArticulatedBody& body, double from, double to, int side = 1) {
    const Points& rest = body.rest_position;
    std::vector<int> faces;
    for (int f = 0; f < body.mesh.faces.rows(); ++f) {
      const auto face = body.mesh.faces.row(f);
      if (std::none_of(face.begin(), face.end(), [&](int v) {
            return side * rest(v, 0) > from && side * rest(v, 0) < to;
          }))
        faces.push_back(f);
    }
    mesh.faces = body.mesh.faces(faces, Eigen::all);
    for (int v : mesh.faces.reshaped()) of_body.emplace(v, 0);
    std::vector<int> kept;
    for (auto& [v, number] : of_body) {
      number = static_cast<int>(kept.size());
      kept.push_back(v);
      is_hand.push_back(side * rest(v, 0) >= to);
    }
    for (int& v : mesh.faces.reshaped()) v = of_body.at(v);
    mesh.vertices = body.mesh.vertices(kept, Eigen::all);
  }

  TriangleMesh mesh;
  std::map<int, int> of_body;
  std::vector<char> is_hand;  ///< beyond the gap
};

/// Of some source vertices: how many have a counterpart, and how far off in square roots of the
/// area.
struct Outcome {
  int all = 0, mapped = 0;
  double error = 0;
};

/// How much longer each edge has become.
Vector edgeRatios(const TriangleMesh& mesh, const Points& places) {
  const std::vector<Edge> edges = meshEdges(mesh.faces);
  Vector ratios(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto length = [&, a = edges[e].first, b = edges[e].second](const Points& points) {
      return (points.row(a) - points.row(b)).norm();
    };
    ratios[static_cast<Eigen::Index>(e)] = length(places) / length(mesh.vertices);
  }
  return ratios;
}

class SeveredArms : public testing::Test {
 protected:
  static double reach() { return body_.rest_position.col(0).maxCoeff(); }

  Outcome outcomeOf(const RegistrationResult& result,
                    const Severed& source,
                    const Severed& target,
                    bool hand) const {
    const double size = rootArea(target.mesh);
    Outcome outcome;
    for (const VertexPair& pair : groundTruth(body_, other_)) {
      const auto s = source.of_body.find(pair.source), t = target.of_body.find(pair.target);
      if (s == source.of_body.end() || t == target.of_body.end()) continue;
      const bool is_hand = source.is_hand[s->second] != 0 || target.is_hand[t->second] != 0;
      if (is_hand != hand) continue;
      ++outcome.all;
      const int found = result.correspondence.on_target[s->second].vertex;
      if (found < 0) continue;
      ++outcome.mapped;
      outcome.error +=
          (target.mesh.vertices.row(found) - target.mesh.vertices.row(t->second)).norm() / size;
    }
    outcome.error /= std::max(1, outcome.mapped);
    return outcome;
  }

  /// The hand as well, although a gap is before it on one side.
  void expectFound(const RegistrationResult& result,
                   const Severed& source,
                   const Severed& target) const {
    EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
    const Outcome body = outcomeOf(result, source, target, false),
                  hand = outcomeOf(result, source, target, true);
    EXPECT_GT(body.mapped, 0.97 * body.all);
    EXPECT_LT(body.error, 0.03);
    EXPECT_GT(hand.mapped, 0.8 * hand.all);
    EXPECT_LT(hand.error, 0.04);
  }

  /// Of what lies farther out along one arm than that, which the target lacks.
  static Outcome outcomeBeyond(const RegistrationResult& result,
                               const Severed& source,
                               double distance,
                               int side) {
    Outcome outcome;
    for (const auto& [v, number] : source.of_body) {
      if (side * body_.rest_position(v, 0) < distance) continue;
      ++outcome.all;
      outcome.mapped += result.correspondence.on_target[number].vertex >= 0;
    }
    return outcome;
  }

  static const ArticulatedBody body_, other_;
};

const ArticulatedBody SeveredArms::body_ = person(0, 0);
const ArticulatedBody SeveredArms::other_ = person(4, 1);

TEST_F(SeveredArms, aHandBeyondAGapFindsItsPlace) {
  const Severed source(body_, 0.6 * reach(), 0.7 * reach()), target(other_, 1e9, 1e9);
  ASSERT_GT(std::count(source.is_hand.begin(), source.is_hand.end(), 1), 30);
  const RegistrationResult result = registerShapes(source.mesh, target.mesh);
  expectFound(result, source, target);
}

TEST_F(SeveredArms, aHandThatTheTargetHasBeyondAGapIsFoundThere) {
  const Severed source(body_, 1e9, 1e9), target(other_, 0.6 * reach(), 0.7 * reach());
  ASSERT_GT(std::count(target.is_hand.begin(), target.is_hand.end(), 1), 30);
  const RegistrationResult result = registerShapes(source.mesh, target.mesh);
  expectFound(result, source, target);
  // It lies there as well, and what lies in the gap does between it and the arm.
  const double edge = meanEdgeLength(target.mesh);
  for (const auto& [v, number] : source.of_body) {
    const SurfacePoint& place = result.correspondence.on_target[number];
    if (place.vertex < 0 || target.is_hand[place.vertex] == 0) continue;
    EXPECT_LT((result.deformed.row(number) - target.mesh.vertices.row(place.vertex)).norm(),
              3 * edge);
  }
  const Vector stretch = edgeRatios(source.mesh, result.deformed);
  EXPECT_LT(stretch.maxCoeff(), 3 * result.scale);
}

TEST_F(SeveredArms, aHandThatTheTargetLacksHasNoCounterpart) {
  const Severed source(body_, 1e9, 1e9), target(other_, 0.55 * reach(), 1e9);
  const RegistrationResult result = registerShapes(source.mesh, target.mesh);
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  const Outcome body = outcomeOf(result, source, target, false);
  EXPECT_GT(body.mapped, 0.97 * body.all);
  EXPECT_LT(body.error, 0.03);
  const Outcome hand = outcomeBeyond(result, source, 0.7 * reach(), 1);
  ASSERT_GT(hand.all, 30);
  EXPECT_LT(hand.mapped, 0.2 * hand.all);
}

/// Without a hole; the numbers of the vertices stay.
TriangleMesh closed(TriangleMesh mesh) {
  const HolePatches patches = patchHoles(mesh);
  const Eigen::Index n = mesh.vertices.rows(), m = mesh.faces.rows();
  mesh.vertices.conservativeResize(n + patches.vertices.rows(), 3);
  mesh.vertices.bottomRows(patches.vertices.rows()) = patches.vertices;
  mesh.faces.conservativeResize(m + patches.faces.rows(), 3);
  mesh.faces.bottomRows(patches.faces.rows()) = patches.faces;
  return mesh;
}

TEST_F(SeveredArms, anArmThatTheTargetLacksHasNoCounterpartThoughTheStumpIsClosed) {
  const double cut = 0.35 * reach();
  const Severed source(body_, 1e9, 1e9);
  Severed target(other_, cut, 1e9);
  target.mesh = closed(target.mesh);
  const std::vector<Edge> edges = meshEdges(target.mesh.faces);
  ASSERT_TRUE(
      std::all_of(edges.begin(), edges.end(), [](const Edge& edge) { return edge.faces == 2; }));
  const RegistrationResult result = registerShapes(source.mesh, target.mesh);
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  const Outcome body = outcomeOf(result, source, target, false);
  EXPECT_GT(body.mapped, 0.95 * body.all);
  EXPECT_LT(body.error, 0.03);
  const Outcome arm = outcomeBeyond(result, source, 0.5 * reach(), 1);
  ASSERT_GT(arm.all, 60);
  EXPECT_LT(arm.mapped, 0.2 * arm.all);
}

TEST_F(SeveredArms, anArmIsNotTakenForTheOtherOne) {
  const Severed source(body_, 0.35 * reach(), 1e9), target(other_, 0.35 * reach(), 1e9, -1);
  const RegistrationResult result = registerShapes(source.mesh, target.mesh);
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  const Outcome body = outcomeOf(result, source, target, false);
  EXPECT_GT(body.mapped, 0.95 * body.all);
  EXPECT_LT(body.error, 0.03);
  const Outcome arm = outcomeBeyond(result, source, 0.5 * reach(), -1);
  ASSERT_GT(arm.all, 60);
  EXPECT_LT(arm.mapped, 0.1 * arm.all);
}

}  // namespace
}  // namespace posture
