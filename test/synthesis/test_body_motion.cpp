// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "body_checks.h"
#include "support/bodies.h"
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace posture {
namespace {

using namespace test;

constexpr int RANDOM_POSE = 10;

class Poses : public ::testing::TestWithParam<std::tuple<BodyKind, int>> {
 protected:
  static const ArticulatedBody& body() {
    static std::map<std::tuple<BodyKind, int>, ArticulatedBody> made;
    const auto [kind, pose] = GetParam();
    const auto [entry, is_new] = made.try_emplace(GetParam());
    if (is_new) entry->second = makeBody(bodyOptions(kind, pose));
    return entry->second;
  }
};
INSTANTIATE_TEST_SUITE_P(
    All,
    Poses,
    ::testing::Combine(::testing::Values(BodyKind::QUADRUPED, BodyKind::HUMAN),
                       ::testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 9, RANDOM_POSE, 11, 57, 1234)),
    [](const auto& tested) {
      return std::string(std::get<0>(tested.param) == BodyKind::HUMAN ? "Human" : "Quadruped") +
             std::to_string(std::get<1>(tested.param));
    });

TEST_P(Poses, keepTheSurface) {
  const Topology topology = topologyOf(body().mesh);
  EXPECT_TRUE(topology.manifold);
  EXPECT_EQ(topology.components, 1);
  EXPECT_EQ(topology.euler, 2);
  const TriangleMesh rest{body().rest_position, body().mesh.faces};
  EXPECT_NEAR(volumeOf(body().mesh), volumeOf(rest), 0.1 * volumeOf(rest));
}

// Skin gives at the joints and nowhere else.
TEST_P(Poses, areNearlyIsometric) {
  const std::vector<double> changes = edgeChangesOf(body());
  EXPECT_LT(changes[changes.size() / 2], 0.02);
  EXPECT_LT(changes[changes.size() * 8 / 10], 0.12);
  EXPECT_LT(changes[changes.size() * 95 / 100], 0.4);
}

TEST_P(Poses, bendTheBody) {
  double moved = 0;
  for (const Eigen::Isometry3d& motion : body().bone_motion)
    moved = std::max(moved, Eigen::AngleAxisd(motion.linear()).angle());
  EXPECT_GT(moved, 0.25);
}

// Folds in the crook of a bent joint are allowed, limbs through the trunk are not.
TEST_P(Poses, hardlyCutThemselves) {
  EXPECT_LT(countSelfIntersections(body().mesh),
            0.02 * static_cast<double>(body().mesh.faces.rows()));
}

TEST_P(Poses, moveRigidPartsAsTheirBones) {
  int rigid = 0;
  for (int v = 0; v < body().rest_position.rows(); ++v) {
    ASSERT_GT(body().bone_weight[v], 0);
    ASSERT_LE(body().bone_weight[v], 1 + 1e-12);
    if (body().bone_weight[v] < 1 - 1e-12) continue;
    ++rigid;
    const Eigen::Vector3d rest = body().rest_position.row(v), posed = body().mesh.vertices.row(v);
    ASSERT_LT((body().bone_motion[body().bone[v]] * rest - posed).norm(), 1e-9) << "vertex " << v;
  }
  EXPECT_GT(rigid, 0.25 * static_cast<double>(body().rest_position.rows()));
}

TEST_P(Poses, haveProperRigidMotions) {
  for (const Eigen::Isometry3d& motion : body().bone_motion) {
    EXPECT_NEAR(motion.linear().determinant(), 1, 1e-9);
    EXPECT_LT((motion.linear() * motion.linear().transpose() - Eigen::Matrix3d::Identity()).norm(),
              1e-9);
  }
}

TEST(RestPose, isTheRestPlace) {
  for (BodyKind kind : {BodyKind::QUADRUPED, BodyKind::HUMAN}) {
    const ArticulatedBody body = makeBody(bodyOptions(kind));
    EXPECT_LT((body.mesh.vertices - body.rest_position).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(RandomPoses, differFromEachOther) {
  const ArticulatedBody a = makeBody(bodyOptions(BodyKind::HUMAN, RANDOM_POSE));
  const ArticulatedBody b = makeBody(bodyOptions(BodyKind::HUMAN, RANDOM_POSE + 1));
  ASSERT_EQ(a.mesh.vertices.rows(), b.mesh.vertices.rows());
  EXPECT_GT((a.mesh.vertices - b.mesh.vertices).rowwise().norm().maxCoeff(), 0.1);
}

TEST(BoneNames, comeInPairs) {
  for (BodyKind kind : {BodyKind::QUADRUPED, BodyKind::HUMAN}) {
    const ArticulatedBody body = makeBody(bodyOptions(kind, 0, 0, 1000));
    const std::set<std::string> names(body.bone_names.begin(), body.bone_names.end());
    EXPECT_EQ(names.size(), body.bone_names.size());
    int pairs = 0;
    for (const std::string& name : names) {
      if (name.size() > 2 && name.substr(name.size() - 2) == "_r") {
        EXPECT_EQ(names.count(name.substr(0, name.size() - 1) + "l"), 1u);
        ++pairs;
      }
    }
    EXPECT_GT(pairs, 3);
  }
}

}  // namespace
}  // namespace posture
