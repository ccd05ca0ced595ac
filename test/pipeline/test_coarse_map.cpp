// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "no_way_on.h"
#include "refined/work/coarse_map.h"
#include "sides/given_shape.h"
#include "sides/pose.h"
#include "support/bodies.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

/// A body and the same one turned, moved and enlarged; the source too coarse, so that it has
/// vertices on its long edges.
class CoarseMap : public testing::Test {
 protected:
  CoarseMap() {
    prepare(source_, true);
    prepare(target_, false);
    known_.deformed = there_.vertices;
    known_.correspondence.on_target.resize(body_.vertices.rows());
  }

  static void prepare(PosedSide& side, bool too_coarse) {
    side.shape = fullSide("source", posed(side.ordered.mesh, side.pose), too_coarse);
    reduceSide("source", static_cast<int>(side.shape.full.vertices.rows()), side.shape);
  }

  static TriangleMesh moved(TriangleMesh body) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    body.vertices = (3 * body.vertices * turn.transpose()).rowwise() + Eigen::RowVector3d(1, 2, 3);
    return body;
  }

  void map(int vertex) { known_.correspondence.on_target[vertex].vertex = vertex; }

  const TriangleMesh body_ = test::person(0).mesh, there_ = moved(body_);
  const CleanMesh clean_ = cleanMesh(body_), clean_there_ = cleanMesh(there_);
  PosedSide source_{GivenShape{body_, clean_}}, target_{GivenShape{there_, clean_there_}};
  RegistrationResult known_;
};

TEST_F(CoarseMap, leadsWhereTheAnswerDoes) {
  for (int v = 0; v < body_.vertices.rows(); ++v) map(v);
  ASSERT_FALSE(source_.shape.parts.empty());
  const BentPair pair = coarseMapOf(source_, target_, known_);
  const TriangleMesh &from = source_.shape.coarse.mesh, &to = target_.shape.coarse.mesh;
  ASSERT_EQ(pair.bent_a.rows(), from.vertices.rows());
  EXPECT_LT((pair.bent_a - from.vertices).rowwise().norm().maxCoeff(), 1e-3);
  EXPECT_EQ(std::count(pair.apart_a.begin(), pair.apart_a.end(), 1), 0);
  EXPECT_EQ(std::count(pair.apart_b.begin(), pair.apart_b.end(), 1), 0);
  const double edge = meanEdgeLength(to);
  for (int v = 0; v < from.vertices.rows(); ++v)
    EXPECT_LT((to.vertices.row(pair.maps.forward[v]) - from.vertices.row(v)).norm(), 3 * edge);
  for (int t = 0; t < to.vertices.rows(); ++t)
    EXPECT_LT((from.vertices.row(pair.maps.backward[t]) - to.vertices.row(t)).norm(), edge);
}

TEST_F(CoarseMap, whatHasNoCounterpartIsApartAndLiesWhereItWasLaid) {
  const double middle = body_.vertices.col(0).mean();
  for (int v = 0; v < body_.vertices.rows(); ++v)
    if (body_.vertices(v, 0) < middle) map(v);
  const BentPair pair = coarseMapOf(source_, target_, known_);
  const TriangleMesh& from = source_.shape.coarse.mesh;
  EXPECT_LT((pair.bent_a - from.vertices).rowwise().norm().maxCoeff(), 1e-3);
  const Points given = source_.pose.outOf(from.vertices);
  for (int v = 0; v < given.rows(); ++v) {
    if (std::abs(given(v, 0) - middle) < 0.1 * rootArea(body_)) continue;
    EXPECT_EQ(pair.apart_a[v] != 0, given(v, 0) > middle);
  }
}

TEST_F(CoarseMap, needsACounterpart) {
  EXPECT_THROW(coarseMapOf(source_, target_, known_), NoWayOn);
}

}  // namespace
}  // namespace posture
