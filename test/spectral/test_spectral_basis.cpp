// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/spectral/spectral_basis.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace posture {
namespace {

constexpr double PI = 3.14159265358979;

SpectralBasis basisOf(const TriangleMesh& mesh, int count) {
  return spectralBasis(cotangentLaplacian(mesh), count);
}

/// A potato: no two of its axes are alike, so no eigenvalue is there twice.
TriangleMesh potato() {
  TriangleMesh mesh = test::sphere(3);
  mesh.vertices *= Eigen::Vector3d(1, 1.3, 1.8).asDiagonal();
  mesh.vertices.col(0) += 0.15 * mesh.vertices.col(2).cwiseAbs2();
  return mesh;
}

void expectOrthonormal(const SpectralBasis& basis, const Vector& mass) {
  const Matrix gram = basis.functions.transpose() * mass.asDiagonal() * basis.functions;
  EXPECT_LT((gram - Matrix::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-8);
}

void expectSolutions(const SpectralBasis& basis,
                     const Laplacian& laplacian,
                     double tolerance = 1e-6) {
  const double largest = basis.eigenvalues.maxCoeff() + 1 / laplacian.mass.sum();
  const Vector inverse_mass = laplacian.mass.cwiseInverse();
  for (int k = 0; k < basis.eigenvalues.size(); ++k) {
    const Vector f = basis.functions.col(k);
    const Vector residual =
        inverse_mass.cwiseProduct(laplacian.stiffness * f) - basis.eigenvalues[k] * f;
    // In the norm in which the functions have length one.
    EXPECT_LT(std::sqrt(residual.dot(laplacian.mass.cwiseProduct(residual))), tolerance * largest)
        << k;
  }
}

TEST(SpectralBasis, ofTheSphereAreItsHarmonics) {
  const int degrees = 6;
  const SpectralBasis basis = basisOf(test::sphere(3), degrees * degrees);
  ASSERT_EQ(basis.eigenvalues.size(), degrees * degrees);
  for (int l = 0, k = 0; l < degrees; ++l)
    for (int m = -l; m <= l; ++m, ++k)
      EXPECT_NEAR(basis.eigenvalues[k], l * (l + 1), 0.05 * l * (l + 1) + 1e-9) << l << " " << m;
}

TEST(SpectralBasis, ofARectangleAreCosines) {
  const double a = 1.3, b = 1;
  const TriangleMesh sheet = test::grid(39, 30, a, b);
  const int count = 20;
  std::vector<double> expected;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      expected.push_back(std::pow(i * PI / a, 2) + std::pow(j * PI / b, 2));
  std::sort(expected.begin(), expected.end());
  const SpectralBasis basis = basisOf(sheet, count);
  for (int k = 0; k < count; ++k)
    EXPECT_NEAR(basis.eigenvalues[k], expected[k], 0.02 * expected[k] + 1e-9) << k;
  // The second is the longest wave along the longer side.
  const Vector wave = (PI / a * sheet.vertices.col(0)).array().cos() * std::sqrt(2 / (a * b));
  const double sign = basis.functions(0, 1) > 0 ? 1 : -1;
  EXPECT_LT((sign * basis.functions.col(1) - wave).cwiseAbs().maxCoeff(), 0.02);
}

TEST(SpectralBasis, isWhatADenseSolverFinds) {
  // Spheres and squares have every multiplicity that a Krylov space can lose.
  for (const TriangleMesh& mesh : {test::sphere(2), test::grid(12, 12, 1, 1), potato()}) {
    const Laplacian laplacian = cotangentLaplacian(mesh);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> dense(
        Matrix(laplacian.stiffness), Matrix(laplacian.mass.asDiagonal()), Eigen::EigenvaluesOnly);
    for (int count = 1; count <= 100; count += 3) {
      const SpectralBasis basis = spectralBasis(laplacian, count);
      ASSERT_EQ(basis.eigenvalues.size(), count);
      const Vector expected = dense.eigenvalues().head(count);
      EXPECT_LT((basis.eigenvalues - expected).cwiseAbs().maxCoeff(),
                1e-6 * dense.eigenvalues()[count])
          << count;
    }
  }
}

TEST(SpectralBasis, isOrthonormalAndSolvesTheEquation) {
  for (const TriangleMesh& mesh : {potato(), test::sphere(3), test::bentStrip(30, 8, 4, 1, 2.5)}) {
    const Laplacian laplacian = cotangentLaplacian(mesh);
    const SpectralBasis basis = spectralBasis(laplacian, 60);
    ASSERT_EQ(basis.functions.rows(), mesh.vertices.rows());
    ASSERT_EQ(basis.functions.cols(), 60);
    expectOrthonormal(basis, laplacian.mass);
    expectSolutions(basis, laplacian);
    EXPECT_TRUE(std::is_sorted(basis.eigenvalues.begin(), basis.eigenvalues.end()));
    // The first is constant, of unit length.
    EXPECT_NEAR(basis.eigenvalues[0], 0, 1e-7);
    const double constant = 1 / std::sqrt(laplacian.mass.sum());
    EXPECT_LT((basis.functions.col(0).cwiseAbs().array() - constant).abs().maxCoeff(),
              1e-6 * constant);
  }
}

TEST(SpectralBasis, doesNotChangeWhenTheSurfaceMoves) {
  const TriangleMesh still = potato();
  TriangleMesh moved = still;
  const Eigen::AngleAxisd turn(1.1, Eigen::Vector3d(3, -1, 2).normalized());
  moved.vertices = (still.vertices * turn.toRotationMatrix().transpose()).rowwise() +
                   Eigen::RowVector3d(5, -7, 3);
  const int count = 30;
  const SpectralBasis before = basisOf(still, count), after = basisOf(moved, count);
  EXPECT_LT((before.eigenvalues - after.eigenvalues).cwiseAbs().maxCoeff(), 1e-6);
  // The last one's neighbour beyond is not known.
  for (int k = 0; k + 1 < count; ++k) {
    const double to_next = before.eigenvalues[k + 1] - before.eigenvalues[k];
    const double to_last = k > 0 ? before.eigenvalues[k] - before.eigenvalues[k - 1]
                                 : std::numeric_limits<double>::infinity();
    if (std::min(to_next, to_last) < 1e-2) continue;  // hardly told apart
    const double same = (before.functions.col(k) - after.functions.col(k)).norm(),
                 opposite = (before.functions.col(k) + after.functions.col(k)).norm();
    EXPECT_LT(std::min(same, opposite), 1e-4 * before.functions.col(k).norm()) << k;
  }
}

TEST(SpectralBasis, doesNotChangeWhenASheetIsBent) {
  // What the method rests on: isometric surfaces have the same spectrum.
  const SpectralBasis flat = basisOf(test::grid(40, 16, 4, 1.3), 20),
                      bent = basisOf(test::bentStrip(40, 16, 4, 1.3, 3), 20);
  for (int k = 1; k < 20; ++k) EXPECT_NEAR(bent.eigenvalues[k] / flat.eigenvalues[k], 1, 0.01) << k;
}

TEST(SpectralBasis, scalesWithTheUnit) {
  const TriangleMesh mesh = potato();
  const SpectralBasis once = basisOf(mesh, 20);
  for (double scale : {1e-6, 1e-3, 25.0, 1e5}) {
    TriangleMesh scaled = mesh;
    scaled.vertices *= scale;
    const SpectralBasis basis = basisOf(scaled, 20);
    const Vector restored = scale * scale * basis.eigenvalues;
    EXPECT_LT((restored - once.eigenvalues).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT((scale * basis.functions.cwiseAbs() - once.functions.cwiseAbs()).norm(), 1e-4);
  }
}

TEST(SpectralBasis, takesTheSmallestMeshes) {
  TriangleMesh triangle;
  triangle.vertices.resize(3, 3);
  triangle.vertices << 0, 0, 0, 1, 0, 0, 0.2, 0.7, 0;
  triangle.faces.resize(1, 3);
  triangle.faces << 0, 1, 2;
  for (const TriangleMesh& mesh : {triangle, test::grid(1, 1, 2, 1), test::sphere(0)}) {
    const Laplacian laplacian = cotangentLaplacian(mesh);
    const int n = static_cast<int>(mesh.vertices.rows());
    for (int count : {1, 2, n, 200}) {
      const SpectralBasis basis = spectralBasis(laplacian, count);
      EXPECT_EQ(basis.eigenvalues.size(), std::min(count, n - 2));
      EXPECT_EQ(basis.functions.cols(), basis.eigenvalues.size());
      expectOrthonormal(basis, laplacian.mass);
      expectSolutions(basis, laplacian);
    }
  }
}

TEST(SpectralBasis, hasAZeroForEveryPart) {
  const TriangleMesh one = test::sphere(2);
  const SpectralBasis basis = basisOf(test::joined(one, test::shifted(one, {5, 0, 0})), 8);
  const Vector expected = (Vector(8) << 0, 0, 2, 2, 2, 2, 2, 2).finished();
  EXPECT_LT((basis.eigenvalues - expected).cwiseAbs().maxCoeff(), 0.1);
}

TEST(SpectralBasis, isIncreasingOnFacesWithoutArea) {
  // A cap on every boundary edge of a strip, its apex all but on that edge.
  TriangleMesh strip = test::grid(30, 6, 5, 1);
  std::vector<Edge> rim;
  for (const Edge& e : meshEdges(strip.faces))
    if (e.faces == 1) rim.push_back(e);
  const int n = static_cast<int>(strip.vertices.rows()), m = static_cast<int>(strip.faces.rows());
  const int caps = static_cast<int>(rim.size());
  const Vector plain = basisOf(strip, 20).eigenvalues;
  strip.vertices.conservativeResize(n + caps, 3);
  strip.faces.conservativeResize(m + caps, 3);
  for (int i = 0; i < caps; ++i) {
    strip.vertices.row(n + i) =
        0.5 * (strip.vertices.row(rim[i].first) + strip.vertices.row(rim[i].second));
    strip.faces.row(m + i) << rim[i].first, rim[i].second, n + i;
  }
  const Laplacian laplacian = cotangentLaplacian(strip);
  const SpectralBasis basis = spectralBasis(laplacian, 20);
  EXPECT_TRUE(std::is_sorted(basis.eigenvalues.begin(), basis.eigenvalues.end()));
  expectOrthonormal(basis, laplacian.mass);
  expectSolutions(basis, laplacian, 1e-4);
  EXPECT_LT((basis.eigenvalues - plain).cwiseAbs().maxCoeff(), 0.2 * plain[19]);
}

TEST(SpectralBasis, refusesWhatHasNoBasis) {
  const Laplacian laplacian = cotangentLaplacian(test::sphere(0));
  EXPECT_THROW(spectralBasis(laplacian, 0), std::invalid_argument);
  EXPECT_THROW(spectralBasis(Laplacian{}, 5), std::invalid_argument);
}

}  // namespace
}  // namespace posture
