// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "body_checks.h"
#include "support/bodies.h"
#include <cmath>
#include <stdexcept>
#include <vector>

namespace posture {
namespace {

using namespace test;

TEST(GroundTruth, isTheIdentityOnOneTessellation) {
  for (BodyKind kind : {BodyKind::QUADRUPED, BodyKind::HUMAN}) {
    const ArticulatedBody &source = body(0, 2500, 0, kind), &target = body(7, 2500, 0, kind);
    const std::vector<VertexPair> truth = groundTruth(source, target);
    ASSERT_EQ(static_cast<Eigen::Index>(truth.size()), source.mesh.vertices.rows());
    for (const VertexPair& pair : truth) ASSERT_EQ(pair.source, pair.target);
  }
}

TEST(GroundTruth, ofAnotherTessellationIsWithinAnEdge) {
  for (BodyKind kind : {BodyKind::QUADRUPED, BodyKind::HUMAN}) {
    const ArticulatedBody &source = body(0, 2500, 0, kind), &target = body(3, 2500, 1, kind);
    const std::vector<VertexPair> truth = groundTruth(source, target);
    EXPECT_GT(static_cast<double>(truth.size()),
              0.995 * static_cast<double>(source.mesh.vertices.rows()));
    const double edge = meanEdgeOf({target.rest_position, target.mesh.faces});
    double sum = 0;
    for (const VertexPair& pair : truth) {
      const double gap =
          (source.rest_position.row(pair.source) - target.rest_position.row(pair.target)).norm();
      ASSERT_LE(gap, edge);
      sum += gap;
    }
    EXPECT_LT(sum / static_cast<double>(truth.size()), 0.5 * edge);
  }
}

// The one and only nearest, against looking at all of them.
TEST(GroundTruth, isTheNearestVertexByRestPlace) {
  const ArticulatedBody source = makeBody(bodyOptions(BodyKind::QUADRUPED, 0, 0, 1000));
  const ArticulatedBody target = makeBody(bodyOptions(BodyKind::QUADRUPED, 2, 5, 2000));
  const std::vector<VertexPair> truth = groundTruth(source, target);
  EXPECT_GT(static_cast<double>(truth.size()),
            0.99 * static_cast<double>(source.mesh.vertices.rows()));
  for (const VertexPair& pair : truth) {
    int nearest = -1;
    (target.rest_position.rowwise() - source.rest_position.row(pair.source))
        .rowwise()
        .squaredNorm()
        .minCoeff(&nearest);
    ASSERT_EQ(pair.target, nearest);
  }
}

TEST(GroundTruth, leavesOutWhatTheTargetLacks) {
  const ArticulatedBody& source = person(0);
  BodyOptions options = bodyOptions(BodyKind::HUMAN, 2);
  options.holes = 4;
  options.hole_radius = 0.06;
  const ArticulatedBody target = makeBody(options);
  const auto lost = source.mesh.vertices.rows() - target.mesh.vertices.rows();
  const auto left_out =
      source.mesh.vertices.rows() - static_cast<Eigen::Index>(groundTruth(source, target).size());
  EXPECT_GT(left_out, lost / 3);  // those near a rim are within an edge of it
  EXPECT_LE(left_out, lost);
}

TEST(MirrorTruth, takesLeftForRight) {
  for (BodyKind kind : {BodyKind::QUADRUPED, BodyKind::HUMAN}) {
    const ArticulatedBody& body = test::body(0, 2500, 0, kind);
    const std::vector<VertexPair> mirror = mirrorTruth(body, body);
    EXPECT_GT(static_cast<double>(mirror.size()),
              0.98 * static_cast<double>(body.mesh.vertices.rows()));
    int forearm = 0, beside = 0;
    for (const VertexPair& pair : mirror) {
      const std::string &from = body.bone_names[body.bone[pair.source]],
                        &to = body.bone_names[body.bone[pair.target]];
      ASSERT_LT((body.rest_position.row(pair.source) - body.rest_position.row(pair.target))
                    .tail<2>()
                    .norm(),
                0.06);
      if (from == "forearm_r") {
        EXPECT_NE(to.substr(to.size() - 2), "_r") << to;
        ++forearm;
      }
      if (std::abs(body.rest_position(pair.source, 0)) > 0.05) {
        EXPECT_LT(body.rest_position(pair.source, 0) * body.rest_position(pair.target, 0), 0)
            << from << " -> " << to;
        ++beside;
      }
    }
    EXPECT_GT(forearm, 0);
    EXPECT_GT(beside, 0);
  }
}

TEST(GroundTruth, needsATargetWithFaces) {
  EXPECT_THROW(groundTruth(person(0), ArticulatedBody()), std::invalid_argument);
}

}  // namespace
}  // namespace posture
