// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "body_checks.h"
#include "support/bodies.h"
#include <cmath>
#include <stdexcept>

namespace posture {
namespace {

using namespace test;

TEST(Holes, areAsManyAsAsked) {
  for (BodyKind kind : {BodyKind::QUADRUPED, BodyKind::HUMAN})
    for (const auto& [holes, radius] : {std::pair(1, 0.05), {12, 0.02}, {40, 0.0}}) {
      BodyOptions options = bodyOptions(kind, 5, 1);
      options.holes = holes;
      options.hole_radius = radius;
      const Topology topology = topologyOf(makeBody(options).mesh);
      EXPECT_TRUE(topology.manifold);
      EXPECT_EQ(topology.rims, holes);
      EXPECT_EQ(topology.components, 1);
      EXPECT_EQ(topology.euler, 2 - holes);
    }
}

TEST(Holes, areAboutAsLargeAsAsked) {
  constexpr double RADIUS = 0.04;
  BodyOptions options = bodyOptions(BodyKind::HUMAN, 0, 0, 10000);
  const double whole = static_cast<double>(makeBody(options).mesh.faces.rows());
  options.holes = 8;
  options.hole_radius = RADIUS;
  const TriangleMesh cut = makeBody(options).mesh;
  const double edge = meanEdgeOf(cut), face = std::sqrt(3.0) / 4 * edge * edge;
  const double lost = (whole - static_cast<double>(cut.faces.rows())) * face;
  EXPECT_NEAR(lost / (8 * 3.14159 * RADIUS * RADIUS), 1, 0.45);  // ways along edges are longer
}

TEST(Holes, lieElsewhereForAnotherSeedOrPose) {
  BodyOptions options = bodyOptions(BodyKind::QUADRUPED);
  options.holes = 6;
  const Points first = makeBody(options).rest_position;
  const auto differs = [&](const BodyOptions& other) {
    const Points places = makeBody(other).rest_position;
    return places.rows() != first.rows() || places != first;
  };
  BodyOptions seed = options, pose = options;
  seed.seed = 2;
  pose.pose = 1;
  EXPECT_FALSE(differs(options));
  EXPECT_TRUE(differs(seed));
  EXPECT_TRUE(differs(pose));
}

TEST(Holes, thatDoNotFitAreRefused) {
  BodyOptions options = bodyOptions(BodyKind::HUMAN, 0, 0, 1000);
  options.holes = 500;
  EXPECT_THROW(makeBody(options), std::invalid_argument);
  options.holes = 1;
  options.hole_radius = 1.0;
  EXPECT_THROW(makeBody(options), std::invalid_argument);
}

TEST(Noise, hasTheDeviationAsked) {
  constexpr double DEVIATION = 0.003;
  BodyOptions options = bodyOptions(BodyKind::QUADRUPED, 1, 0, 5000);
  const Points clean = makeBody(options).mesh.vertices;
  options.noise = DEVIATION;
  const ArticulatedBody noisy = makeBody(options);
  ASSERT_EQ(noisy.mesh.vertices.rows(), clean.rows());
  const double rms = std::sqrt((noisy.mesh.vertices - clean).rowwise().squaredNorm().mean());
  EXPECT_NEAR(rms / DEVIATION, 1, 0.05);  // of 5,000 draws it is within 1 % most of the time
  EXPECT_LT(std::abs(volumeOf(noisy.mesh) / volumeOf({clean, noisy.mesh.faces}) - 1), 0.05);
}

TEST(Noise, leavesRestPlacesAlone) {
  BodyOptions options = bodyOptions(BodyKind::HUMAN, 0);
  const Points clean = makeBody(options).rest_position;
  options.noise = 0.01;
  EXPECT_TRUE(makeBody(options).rest_position == clean);
}

}  // namespace
}  // namespace posture
