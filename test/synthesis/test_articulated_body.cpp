// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "body_checks.h"
#include "support/bodies.h"
#include <limits>
#include <omp.h>
#include <stdexcept>

namespace posture {
namespace {

using namespace test;

class Bodies : public ::testing::TestWithParam<BodyKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds,
                         Bodies,
                         ::testing::Values(BodyKind::QUADRUPED, BodyKind::HUMAN),
                         [](const auto& tested) {
                           return tested.param == BodyKind::HUMAN ? "Human" : "Quadruped";
                         });

/// Before what the library has at namespace scope need be initialised.
const ArticulatedBody MADE_BEFORE_MAIN[] = {makeBody(bodyOptions(BodyKind::QUADRUPED, 4)),
                                            makeBody(bodyOptions(BodyKind::HUMAN, 4))};

TEST_P(Bodies, areTheSameBeforeMainAndWithAnyNumberOfThreads) {
  const ArticulatedBody& before = MADE_BEFORE_MAIN[GetParam() == BodyKind::HUMAN ? 1 : 0];
  const int threads = omp_get_max_threads();
  for (int count : {1, 4}) {
    omp_set_num_threads(count);
    const ArticulatedBody now = makeBody(bodyOptions(GetParam(), 4));
    EXPECT_EQ(before.mesh.vertices, now.mesh.vertices) << count;
    EXPECT_EQ(before.mesh.faces, now.mesh.faces) << count;
    EXPECT_EQ(before.bone, now.bone) << count;
  }
  omp_set_num_threads(threads);
}

const TriangleMesh& meshAtRest(BodyKind kind, int tessellation) {
  return body(0, 2500, tessellation, kind).mesh;
}

TEST_P(Bodies, areClosedManifoldAndOfGenusZero) {
  for (int tessellation = 0; tessellation < 8; ++tessellation) {
    const TriangleMesh& mesh = meshAtRest(GetParam(), tessellation);
    const Topology topology = topologyOf(mesh);
    EXPECT_TRUE(topology.manifold) << "tessellation " << tessellation;
    EXPECT_EQ(topology.rims, 0) << "tessellation " << tessellation;
    EXPECT_EQ(topology.components, 1) << "tessellation " << tessellation;
    EXPECT_EQ(topology.euler, 2) << "tessellation " << tessellation;
    EXPECT_GT(volumeOf(mesh), 0.005) << "tessellation " << tessellation;
    EXPECT_EQ(countSelfIntersections(mesh), 0) << "tessellation " << tessellation;
  }
}

TEST_P(Bodies, haveAboutTheVerticesAskedForInWellShapedTriangles) {
  for (int vertices : {1500, 5000, 10000})
    for (int tessellation : {0, 3}) {
      const TriangleMesh mesh = makeBody(bodyOptions(GetParam(), 0, tessellation, vertices)).mesh;
      EXPECT_NEAR(static_cast<double>(mesh.vertices.rows()), vertices, 0.05 * vertices);
      EXPECT_GT(smallestAngleOf(mesh), 15.0) << vertices << " vertices";
    }
}

TEST_P(Bodies, standUprightLookForwardAndAreAboutOneLong) {
  const Points& places = meshAtRest(GetParam(), 0).vertices;
  const Eigen::RowVector3d low = places.colwise().minCoeff(), high = places.colwise().maxCoeff();
  EXPECT_NEAR(low.z(), 0, 0.02);
  EXPECT_GT((high - low).maxCoeff(), 0.9);
  EXPECT_LT((high - low).maxCoeff(), 1.3);
}

TEST_P(Bodies, areNearlyButNotExactlySymmetric) {
  const ArticulatedBody body = makeBody(bodyOptions(GetParam(), 0, 0, 5000));
  Points reflected = body.rest_position;
  reflected.col(0) *= -1;
  double sum = 0, most = 0;
  for (int i = 0; i < reflected.rows(); i += 5) {
    const double gap =
        (body.rest_position.rowwise() - reflected.row(i)).rowwise().norm().minCoeff();
    sum += gap;
    most = std::max(most, gap);
  }
  // An exactly symmetric body would still be about 0.4 edges away: vertices lie differently.
  EXPECT_LT(5 * sum / static_cast<double>(reflected.rows()), meanEdgeOf(body.mesh));
  EXPECT_LT(most, 0.03);
  const Eigen::RowVector3d centre = body.rest_position.colwise().mean();
  EXPECT_GT(std::abs(centre.x()), 1e-4);
}

TEST_P(Bodies, comeOutTheSameEveryTime) {
  BodyOptions options = bodyOptions(GetParam(), 4, 2);
  options.holes = 5;
  options.noise = 0.001;
  const ArticulatedBody a = makeBody(options), b = makeBody(options);
  EXPECT_TRUE(a.mesh.vertices == b.mesh.vertices);
  EXPECT_TRUE(a.mesh.faces == b.mesh.faces);
  EXPECT_TRUE(a.rest_position == b.rest_position);
  EXPECT_EQ(a.bone, b.bone);
}

TEST_P(Bodies, areMeshedAnewByAnotherTessellation) {
  const TriangleMesh &a = meshAtRest(GetParam(), 0), &b = meshAtRest(GetParam(), 1);
  EXPECT_FALSE(a.vertices.rows() == b.vertices.rows() && a.vertices == b.vertices);
  EXPECT_NEAR(volumeOf(a), volumeOf(b), 0.01 * volumeOf(a));
}

TEST_P(Bodies, describeEveryVertexAndBone) {
  const ArticulatedBody body = makeBody(bodyOptions(GetParam(), 3));
  const auto n = static_cast<std::size_t>(body.mesh.vertices.rows());
  EXPECT_EQ(static_cast<std::size_t>(body.rest_position.rows()), n);
  EXPECT_EQ(body.bone.size(), n);
  EXPECT_EQ(static_cast<std::size_t>(body.bone_weight.size()), n);
  EXPECT_EQ(body.bone_motion.size(), body.bone_names.size());
  std::vector<int> vertices_of(body.bone_names.size(), 0);
  for (int bone : body.bone) ++vertices_of.at(bone);
  for (std::size_t b = 0; b < vertices_of.size(); ++b)
    EXPECT_GT(vertices_of[b], 0) << body.bone_names[b] << " moves nothing most";
}

TEST(BodyOptionsCheck, rejectsWhatMakesNoBody) {
  const auto with = [](auto change) {
    BodyOptions options;
    change(options);
    return options;
  };
  constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
  for (const BodyOptions& options : {with([](auto& o) { o.vertices = 999; }),
                                     with([](auto& o) { o.holes = -1; }),
                                     with([](auto& o) { o.hole_radius = -0.1; }),
                                     with([](auto& o) { o.hole_radius = NOT_A_NUMBER; }),
                                     with([](auto& o) { o.noise = -1; }),
                                     with([](auto& o) { o.noise = NOT_A_NUMBER; })})
    EXPECT_THROW(makeBody(options), std::invalid_argument);
}

}  // namespace
}  // namespace posture
