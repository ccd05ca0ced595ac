// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/deformation/arap.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "support/motions.h"
#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

using test::motion;
using test::moved;

/// A surface with what bends it.
struct Bendable {
  explicit Bendable(const TriangleMesh& surface)
      : mesh(surface), laplacian(cotangentLaplacian(mesh)), arap(mesh, laplacian) {}

  TriangleMesh mesh;
  Laplacian laplacian;
  Arap arap;
};

int vertexCount(const Bendable& surface) { return static_cast<int>(surface.mesh.vertices.rows()); }

/// Mean distance between corresponding places.
double gap(const Points& x, const Points& y) { return (x - y).rowwise().norm().mean(); }

/// The strain of the definition: each vertex with the rotation that suits it best, found by
/// singular values (Kabsch).
double strain(const Bendable& surface, const Points& bent) {
  const Points& rest = surface.mesh.vertices;
  const Matrix stiffness(surface.laplacian.stiffness);
  double sum = 0;
  for (int i = 0; i < rest.rows(); ++i) {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                                  Eigen::ComputeFullU | Eigen::ComputeFullV);
      const double det = (svd.matrixU() * svd.matrixV().transpose()).determinant();
      const Eigen::Matrix3d rotation = svd.matrixU() *
                                       Eigen::Vector3d(1, 1, det < 0 ? -1 : 1).asDiagonal() *
                                       svd.matrixV().transpose();
      for (int j = 0; j < rest.rows(); ++j) {
        const double weight = -stiffness(i, j);
        if (j == i || weight <= 0) continue;
        const Eigen::Vector3d now = bent.row(i) - bent.row(j), once = rest.row(i) - rest.row(j);
        if (pass == 0)
          covariance += weight * now * once.transpose();
        else
          sum += 0.5 * weight * (now - rotation * once).squaredNorm();
      }
    }
  }
  return sum;
}

Points noisy(const Points& places, double amount) {
  return places + amount * test::randomPoints(static_cast<int>(places.rows()), 7);
}

TEST(Arap, findsTheRotationOfARigidMotion) {
  for (const TriangleMesh& mesh : {test::sphere(2), test::grid(8, 5, 2, 1)})
    for (double angle : {0.0, 0.5, 2.0, 3.14159}) {
      const Bendable surface(mesh);
      const Eigen::Isometry3d by = motion(angle);
      const auto rotations = surface.arap.rotations(moved(mesh.vertices, by));
      ASSERT_EQ(rotations.size(), static_cast<std::size_t>(mesh.vertices.rows()));
      for (const Eigen::Matrix3d& r : rotations) EXPECT_LT((r - by.linear()).norm(), 1e-6);
    }
}

TEST(Arap, rotationsAreRotationsWhateverTheShape) {
  const Bendable surface(test::sphere(2));
  Points mirrored = surface.mesh.vertices, flat = mirrored, line = mirrored;
  mirrored.col(1) *= -1;
  flat.col(2).setZero();
  line.rightCols(2).setZero();
  const Points nowhere = Points::Zero(mirrored.rows(), 3);
  const Points anything = test::randomPoints(static_cast<int>(mirrored.rows()), 3);
  for (const Points& bent : {mirrored, flat, line, nowhere, anything})
    for (const Eigen::Matrix3d& r : surface.arap.rotations(bent)) {
      EXPECT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-6);
      EXPECT_NEAR(r.determinant(), 1, 1e-6);
    }
}

TEST(Arap, rotationsAreThoseOfTheirVertices) {
  // Bent about an axis, each place along the strip has turned by an angle of its own. At the ends
  // all neighbours are on one side: half the 0.1 radians between columns.
  const double angle = 2, length = 2;
  const Bendable surface(test::grid(20, 6, length, 1));
  const auto rotations = surface.arap.rotations(test::bentStrip(20, 6, length, 1, angle).vertices);
  const double along = surface.mesh.vertices.col(0).minCoeff();
  for (int v = 0; v < vertexCount(surface); ++v) {
    const double expected = angle * (surface.mesh.vertices(v, 0) - along) / length;
    const double turned = Eigen::AngleAxisd(rotations[v]).angle();
    EXPECT_NEAR(turned, expected, 0.06) << v;
  }
}

TEST(Arap, reachesARigidlyMovedCopy) {
  for (const TriangleMesh& mesh : {test::sphere(2), test::grid(8, 5, 2, 1)}) {
    const Bendable surface(mesh);
    const Points goals = moved(mesh.vertices, motion(1.0));
    const Arap::Attraction attraction = surface.arap.attract(10);
    const Points far = surface.arap.pull(mesh.vertices, goals, attraction, 300);
    EXPECT_LT(gap(far, goals), 1e-6);
    EXPECT_NEAR(surface.arap.energy(far), 0, 1e-9);
    const Points there = surface.arap.pull(goals, goals, attraction, 1);
    EXPECT_LT(gap(there, goals), 1e-9);
    EXPECT_NEAR(surface.arap.energy(there), 0, 1e-15);
  }
}

TEST(Arap, energyIsTheStrainOverTheArea) {
  TriangleMesh flattened = test::sphere(2);
  flattened.vertices.col(2) *= 0.1;  // its obtuse faces have negative weights
  for (const TriangleMesh& mesh : {test::sphere(2), flattened}) {
    const Bendable surface(mesh);
    const Points bent = noisy(mesh.vertices, 0.1);
    const Points stays = surface.arap.pull(bent, bent, surface.arap.attract(1), 0);
    EXPECT_EQ(stays, bent);
    const double expected = strain(surface, bent) / surface.laplacian.mass.sum();
    EXPECT_NEAR(surface.arap.energy(stays), expected, 1e-9 * expected);
  }
}

TEST(Arap, energyHasNoUnit) {
  TriangleMesh mesh = test::sphere(2);
  const Points shape = noisy(mesh.vertices, 0.1);
  const Bendable surface(mesh);
  mesh.vertices *= 1000;
  const Bendable large(mesh);
  const Points once = surface.arap.pull(shape, shape, surface.arap.attract(5), 4);
  const Points again = large.arap.pull(1000 * shape, 1000 * shape, large.arap.attract(5e-6), 4);
  EXPECT_GT(surface.arap.energy(once), 1e-3);
  EXPECT_NEAR(large.arap.energy(again), surface.arap.energy(once), 1e-9);
  EXPECT_LT(gap(again, 1000 * once), 1e-6);
}

TEST(Arap, whatIsMinimisedNeverRises) {
  const Bendable surface(test::grid(10, 6, 2, 1));
  const Points goals = noisy(test::bentStrip(10, 6, 2, 1, 2).vertices, 0.05);
  Vector confidence = Vector::Ones(vertexCount(surface));
  for (int v = 0; v < vertexCount(surface); v += 3) confidence[v] = 0.1;
  const double softness = 20;
  const Arap::Attraction attraction = surface.arap.attract(softness, confidence);
  const auto total = [&](int iterations) {
    const Points result = surface.arap.pull(surface.mesh.vertices, goals, attraction, iterations);
    EXPECT_GE(surface.arap.energy(result), 0);
    const Vector strength = softness * confidence.cwiseProduct(surface.laplacian.mass);
    return strain(surface, result) + strength.dot((result - goals).rowwise().squaredNorm());
  };
  double before = total(0);
  for (int iterations : {1, 2, 3, 5, 8, 13, 40, 200}) {
    const double after = total(iterations);
    EXPECT_LT(after, before) << iterations;
    before = after;
  }
  // And no step from the end leads further down.
  const Points end = surface.arap.pull(surface.mesh.vertices, goals, attraction, 2000);
  const Vector strength = softness * confidence.cwiseProduct(surface.laplacian.mass);
  const auto at = [&](const Points& p) {
    return strain(surface, p) + strength.dot((p - goals).rowwise().squaredNorm());
  };
  const double least = at(end);
  for (int seed = 0; seed < 5; ++seed) {
    const Points step = 1e-3 * test::randomPoints(vertexCount(surface), seed);
    EXPECT_GT(at(end + step), least);
  }
}

TEST(Arap, followsLargeFormsAndSmoothsSmallOnes) {
  // Goals are right in the mean, but wrong vertex by vertex.
  const Bendable surface(test::grid(20, 10, 2, 1));
  const Points rolled = test::bentStrip(20, 10, 2, 1, 1.5).vertices;
  const Points goals = noisy(rolled, 0.05);
  const Points soft = surface.arap.pull(goals, goals, surface.arap.attract(20), 50);
  const Points softer = surface.arap.pull(goals, goals, surface.arap.attract(2e4), 50);
  EXPECT_LT(gap(soft, rolled), 0.5 * gap(goals, rolled));
  EXPECT_LT(gap(softer, goals), 0.3 * gap(goals, rolled));
  EXPECT_LT(surface.arap.energy(soft), surface.arap.energy(softer));
}

TEST(Arap, doesNotHeedGoalsThatAreNotBelieved) {
  const Bendable surface(test::sphere(2));
  Points goals = moved(surface.mesh.vertices, motion(0.3));
  Vector confidence = Vector::Ones(vertexCount(surface));
  const Points truth = goals;
  for (int v = 0; v < vertexCount(surface); v += 4) {
    goals.row(v) << 9, 9, 9;
    confidence[v] = 0;
  }
  const Arap::Attraction attraction = surface.arap.attract(10, confidence);
  const Points result = surface.arap.pull(surface.mesh.vertices, goals, attraction, 300);
  EXPECT_LT(gap(result, truth), 1e-5);
}

TEST(Arap, aFewHandlesMoveEverything) {
  const Bendable surface(test::sphere(2));
  const Points truth = moved(surface.mesh.vertices, motion(0.2));
  Points goals = Points::Zero(truth.rows(), 3);
  Vector confidence = Vector::Zero(truth.rows());
  for (int v : {0, 40, 80, 120, 160}) {
    goals.row(v) = truth.row(v);
    confidence[v] = 1;
  }
  const Arap::Attraction attraction = surface.arap.attract(1e4, confidence);
  const Points result = surface.arap.pull(surface.mesh.vertices, goals, attraction, 2000);
  ASSERT_TRUE(result.allFinite());
  EXPECT_LT(gap(result, truth), 0.01);
  EXPECT_LT(surface.arap.energy(result), 1e-3);
}

TEST(Arap, isFiniteWhereNothingPullsAndNothingHolds) {
  TriangleMesh mesh = test::grid(4, 4, 1, 1);
  const int n = static_cast<int>(mesh.vertices.rows()), m = static_cast<int>(mesh.faces.rows());
  mesh.vertices.conservativeResize(n + 2, 3);
  mesh.vertices.bottomRows(2) << 0, 0, 0, 9, 9, 9;  // at the place of vertex 0, and in no face
  mesh.faces.conservativeResize(m + 1, 3);
  mesh.faces.row(m) << 0, 1, n;
  const Bendable surface(mesh);
  const Points goals = moved(mesh.vertices, motion(0.5));
  for (const Vector& confidence : {Vector(), Vector(Vector::Zero(n + 2))}) {
    const Arap::Attraction attraction = surface.arap.attract(10, confidence);
    const Points result = surface.arap.pull(mesh.vertices, goals, attraction, 20);
    EXPECT_TRUE(result.allFinite());
    EXPECT_GE(surface.arap.energy(result), 0);
    EXPECT_LT(surface.arap.energy(result), 1);
  }
}

TEST(Arap, saysSoWhereNothingTellsAPlace) {
  TriangleMesh mesh = test::sphere(1);
  mesh.vertices.conservativeResize(mesh.vertices.rows() + 1, 3);
  mesh.vertices.bottomRows(1).setZero();  // in no face
  EXPECT_THROW(Bendable(mesh).arap.attract(0), TornSurface);
}

TEST(Arap, refusesSizesThatDoNotFit) {
  const TriangleMesh sphere = test::sphere(1);
  EXPECT_THROW(Arap(sphere, cotangentLaplacian(test::sphere(0))), std::invalid_argument);
  const Bendable surface(sphere), other(test::sphere(0));
  const Points& right = sphere.vertices;
  const Points wrong = right.topRows(5);
  EXPECT_THROW(surface.arap.attract(1, Vector::Ones(5)), std::invalid_argument);
  EXPECT_THROW(surface.arap.attract(1, {}, wrong), std::invalid_argument);
  const Arap::Attraction attraction = surface.arap.attract(1);
  EXPECT_THROW(surface.arap.pull(wrong, right, attraction, 1), std::invalid_argument);
  EXPECT_THROW(surface.arap.pull(right, wrong, attraction, 1), std::invalid_argument);
  EXPECT_THROW(surface.arap.pull(right, right, other.arap.attract(1), 1), std::invalid_argument);
  EXPECT_THROW(surface.arap.rotations(wrong), std::invalid_argument);
  EXPECT_THROW(surface.arap.energy(wrong), std::invalid_argument);
}

}  // namespace
}  // namespace posture
