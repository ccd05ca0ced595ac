// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/refine/bend.h>
#include <posture/refine/map_score.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "refine/poses.h"
#include "support/bodies.h"
#include "support/shapes.h"

namespace posture {
namespace {

const std::vector<int> COARSE{12, 24, 36, 48, 60}, FINE{40, 55, 70, 85, 100, 115, 130};

void expectNearIdentity(const test::Poses& poses, const VertexMaps& maps, double edges) {
  EXPECT_LT(test::meanError(poses.b, maps.forward), edges);
  EXPECT_LT(test::meanError(poses.a, maps.backward), edges);
}

/// How far apart two maps are on the target, in mean edge lengths.
double meanGap(const SpectralSurface& target,
               const std::vector<int>& x,
               const std::vector<int>& y) {
  double sum = 0;
  for (std::size_t v = 0; v < x.size(); ++v)
    sum += (target.mesh.vertices.row(x[v]) - target.mesh.vertices.row(y[v])).norm();
  return sum / static_cast<double>(x.size()) / meanEdgeLength(target.mesh);
}

/// Any map of these surfaces.
void expectMaps(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps) {
  ASSERT_EQ(maps.forward.size(), static_cast<std::size_t>(a.mesh.vertices.rows()));
  ASSERT_EQ(maps.backward.size(), static_cast<std::size_t>(b.mesh.vertices.rows()));
  for (int v : maps.forward) EXPECT_TRUE(v >= 0 && v < b.mesh.vertices.rows());
  for (int v : maps.backward) EXPECT_TRUE(v >= 0 && v < a.mesh.vertices.rows());
}

TEST(Bend, bringsAPerturbedMapBackBetweenPoses) {
  for (BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED}) {
    const test::Poses& poses = test::poses(kind);
    for (int steps : {1, 3, 8}) {
      const VertexMaps start = test::perturbed(poses, steps, 1);
      EXPECT_GT(test::meanError(poses.b, start.forward), 0.9);
      const VertexMaps bent = bend(poses.a, poses.b, COARSE, start);
      expectNearIdentity(poses, bent, 0.4);
      EXPECT_GT(orientation(poses.a, poses.b, bent), 0.98);
    }
  }
}

TEST(Sharpen, bringsAPerturbedMapBackBetweenPoses) {
  for (BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED}) {
    const test::Poses& poses = test::poses(kind);
    for (int steps : {1, 3}) {
      const VertexMaps start = test::perturbed(poses, steps, 1);
      expectNearIdentity(poses, sharpen(poses.a, poses.b, FINE, start), 0.25);
    }
  }
}

TEST(Sharpen, addsToWhatBendingFound) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const VertexMaps bent = bend(poses.a, poses.b, COARSE, test::perturbed(poses, 3, 1));
  const VertexMaps sharp = sharpen(poses.a, poses.b, FINE, bent);
  EXPECT_LT(test::meanError(poses.b, sharp.forward) + test::meanError(poses.a, sharp.backward),
            test::meanError(poses.b, bent.forward) + test::meanError(poses.a, bent.backward));
}

TEST(Bend, isTheSameBothWays) {
  const test::Poses& poses = test::poses(BodyKind::QUADRUPED);
  const VertexMaps start = test::perturbed(poses, 2, 3);
  for (const auto& refine : {bend, sharpen}) {
    const VertexMaps there = refine(poses.a, poses.b, {30, 50}, start),
                     back = refine(poses.b, poses.a, {30, 50}, {start.backward, start.forward});
    // But for the leading directions, which come from one of the two sides.
    EXPECT_LT(meanGap(poses.b, there.forward, back.backward), 0.1);
    EXPECT_LT(meanGap(poses.a, there.backward, back.forward), 0.1);
  }
}

TEST(Bend, leavesTheIdentityOfARigidMotion) {
  const test::Poses& poses = test::poses(BodyKind::QUADRUPED);
  TriangleMesh moved = poses.a.mesh;
  const Eigen::AngleAxisd turn(2.1, Eigen::Vector3d(1, -2, 3).normalized());
  moved.vertices = (moved.vertices * turn.toRotationMatrix().transpose()).rowwise() +
                   Eigen::RowVector3d(0.4, 0.5, 0.6);
  const SpectralSurface b = test::spectralSurface(moved, 150);
  const VertexMaps same = test::identity(poses.a);
  for (const auto& refine : {bend, sharpen}) {
    const VertexMaps maps = refine(poses.a, b, {60}, same);
    EXPECT_EQ(maps.forward, same.forward);
    EXPECT_EQ(maps.backward, same.backward);
  }
}

TEST(Bend, doesNotDependOnTheBasis) {
  // Other functions that span the same, mixed by any rotation.
  const int k = 60;
  const SpectralSurface& a = test::poses(BodyKind::QUADRUPED).a;
  Matrix functions = a.functions.leftCols(k).cast<double>();
  functions *= test::randomRotation(k, 1);
  const SpectralSurface mixed(a.mesh, functions, a.eigenvalues.head(k));
  const VertexMaps same = test::identity(a);
  for (const auto& refine : {bend, sharpen}) {
    const VertexMaps maps = refine(a, mixed, {k}, same);
    EXPECT_EQ(maps.forward, same.forward);
    EXPECT_EQ(maps.backward, same.backward);
  }
  SampleMap all{same.forward, same.backward, 0};
  const VertexMaps spread = spreadToVertices(a, mixed, a.functions, mixed.functions, all, k);
  EXPECT_EQ(spread.forward, same.forward);
  EXPECT_EQ(spread.backward, same.backward);
}

TEST(Bend, takesNoMoreFunctionsThanThereAre) {
  const test::Poses& poses = test::poses(BodyKind::QUADRUPED);
  const VertexMaps start = test::perturbed(poses, 1, 4);
  for (const auto& refine : {bend, sharpen})
    EXPECT_EQ(refine(poses.a, poses.b, {150}, start).forward,
              refine(poses.a, poses.b, {9999}, start).forward);
}

TEST(Bend, registersAnotherTriangulation) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const ArticulatedBody other = test::body(3, 1300, 1, BodyKind::HUMAN);
  const SpectralSurface b = test::spectralSurface(other.mesh, 150);
  VertexMaps truth;
  truth.forward.assign(poses.a.mesh.vertices.rows(), 0);
  truth.backward.assign(b.mesh.vertices.rows(), 0);
  for (const VertexPair& p : groundTruth(poses.body_a, other)) truth.forward[p.source] = p.target;
  for (const VertexPair& p : groundTruth(other, poses.body_a)) truth.backward[p.source] = p.target;
  const VertexMaps noise = test::perturbed(poses, 4, 5);
  VertexMaps maps = truth;
  for (std::size_t v = 0; v < maps.forward.size(); ++v)
    maps.forward[v] = truth.forward[noise.forward[v]];
  for (int& v : maps.backward) v = noise.backward[v];
  maps = sharpen(poses.a, b, FINE, bend(poses.a, b, COARSE, maps));
  expectMaps(poses.a, b, maps);
  EXPECT_LT(meanGap(b, maps.forward, truth.forward), 1);
  EXPECT_LT(meanGap(poses.a, maps.backward, truth.backward), 1);
}

TEST(SpreadToVertices, givesEveryVertexWhatItsSamplesSay) {
  for (BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED}) {
    const test::Poses& poses = test::poses(kind);
    const test::Samples samples(poses.a, 200);
    // Samples at the same vertices of both.
    Eigen::MatrixXf on_b(200, poses.b.functions.cols());
    SampleMap same;
    for (int i = 0; i < 200; ++i) {
      on_b.row(i) = poses.b.functions.row(samples.landmarks.vertices[i]);
      same.forward.push_back(i);
    }
    same.backward = same.forward;
    const VertexMaps maps =
        spreadToVertices(poses.a, poses.b, samples.shape.functions, on_b, same, 60);
    expectMaps(poses.a, poses.b, maps);
    expectNearIdentity(poses, maps, 1);
    const VertexMaps itself = spreadToVertices(
        poses.a, poses.a, samples.shape.functions, samples.shape.functions, same, 60);
    EXPECT_EQ(itself.forward, test::identity(poses.a).forward);
    EXPECT_EQ(itself.backward, test::identity(poses.a).backward);
  }
}

}  // namespace
}  // namespace posture
