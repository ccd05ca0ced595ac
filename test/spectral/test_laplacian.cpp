// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/spectral/laplacian.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

int vertexCount(const TriangleMesh& mesh) { return static_cast<int>(mesh.vertices.rows()); }

/// A rectangle with its inner vertices moved about in the plane: faces of all shapes, none folded.
TriangleMesh unevenGrid(int columns, int rows, double width, double height) {
  TriangleMesh mesh = test::grid(columns, rows, width, height);
  const std::vector<char> on_boundary = boundaryVertices(mesh.faces, vertexCount(mesh));
  Rng rng(1);
  for (int v = 0; v < vertexCount(mesh); ++v)
    if (!on_boundary[v]) {
      mesh.vertices(v, 0) += width / columns * 0.6 * (rng.uniform() - 0.5);
      mesh.vertices(v, 1) += height / rows * 0.6 * (rng.uniform() - 0.5);
    }
  return mesh;
}

/// A sphere with every vertex moved about: nothing symmetric, nothing smooth.
TriangleMesh crumpledSphere(int levels) {
  TriangleMesh mesh = test::sphere(levels);
  mesh.vertices += 0.2 * meanEdgeLength(mesh) * test::randomPoints(vertexCount(mesh), 2);
  return mesh;
}

double leastEigenvalue(const Laplacian& laplacian) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(Matrix(laplacian.stiffness),
                                                     Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0];
}

TEST(Laplacian, isSymmetricAndTakesConstantsToZero) {
  for (const TriangleMesh& mesh : {crumpledSphere(3), unevenGrid(12, 9, 4, 1)}) {
    const Laplacian laplacian = cotangentLaplacian(mesh);
    const Vector ones = Vector::Ones(vertexCount(mesh));
    EXPECT_LT((laplacian.stiffness * ones).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LT((Matrix(laplacian.stiffness) - Matrix(laplacian.stiffness).transpose()).norm(),
              1e-12);
  }
}

TEST(Laplacian, linearFunctionsAreHarmonicInsideAPlane) {
  TriangleMesh sheet = unevenGrid(12, 9, 4, 1);
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  sheet.vertices = (sheet.vertices * turn.toRotationMatrix().transpose()).eval();
  const Laplacian laplacian = cotangentLaplacian(sheet);
  const Points flow = laplacian.stiffness * sheet.vertices;  // three linear functions at once
  const std::vector<char> on_boundary = boundaryVertices(sheet.faces, vertexCount(sheet));
  for (int v = 0; v < vertexCount(sheet); ++v) {
    if (on_boundary[v]) continue;
    EXPECT_LT(flow.row(v).norm(), 1e-12) << v;
  }
}

TEST(Laplacian, givesTheDirichletEnergyOfLinearFunctions) {
  // The integral of the squared slope: exact for linear elements, whatever the triangulation.
  const TriangleMesh sheet = unevenGrid(12, 9, 4, 1);
  const Laplacian laplacian = cotangentLaplacian(sheet);
  const Vector f = 2 * sheet.vertices.col(0) - 3 * sheet.vertices.col(1);
  EXPECT_NEAR(f.dot(laplacian.stiffness * f), (2 * 2 + 3 * 3) * 4.0 * 1.0, 1e-9);
}

TEST(Laplacian, givesTheCurvatureOfASphere) {
  // Of the places themselves it is the mean curvature normal: twice the places times the areas.
  const TriangleMesh sphere = test::sphere(4);
  const Laplacian laplacian = cotangentLaplacian(sphere);
  const Points expected = 2 * laplacian.mass.asDiagonal() * sphere.vertices;
  EXPECT_LT((laplacian.stiffness * sphere.vertices - expected).norm(), 0.01 * expected.norm());
}

TEST(Laplacian, doesNotChangeWithScaleButItsMassDoes) {
  TriangleMesh mesh = crumpledSphere(2);
  const Laplacian before = cotangentLaplacian(mesh);
  mesh.vertices *= 1000;
  const Laplacian after = cotangentLaplacian(mesh);
  EXPECT_LT((Matrix(before.stiffness) - Matrix(after.stiffness)).norm(), 1e-9);
  EXPECT_LT((1e6 * before.mass - after.mass).norm(), 1e-9 * after.mass.norm());
}

TEST(Laplacian, massIsAThirdOfTheFacesAround) {
  for (const TriangleMesh& mesh : {crumpledSphere(3), unevenGrid(12, 9, 4, 1)}) {
    const Laplacian laplacian = cotangentLaplacian(mesh);
    const Vector areas = faceAreas(mesh);
    EXPECT_NEAR(laplacian.mass.sum(), areas.sum(), 1e-12 * areas.sum());
    Vector expected = Vector::Zero(vertexCount(mesh));
    for (int f = 0; f < mesh.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k) expected[mesh.faces(f, k)] += areas[f] / 3;
    EXPECT_LT((laplacian.mass - expected).norm(), 1e-12 * areas.sum());
  }
}

TEST(Laplacian, isPositiveSemiDefinite) {
  EXPECT_GT(leastEigenvalue(cotangentLaplacian(crumpledSphere(2))), -1e-10);
  EXPECT_GT(leastEigenvalue(cotangentLaplacian(unevenGrid(12, 9, 4, 1))), -1e-10);
}

TEST(Laplacian, isPositiveSemiDefiniteOnNeedlesAndCaps) {
  // One face that the apex lies ever nearer to the opposite side of, at its middle or near its end.
  TriangleMesh face;
  face.vertices.resize(3, 3);
  face.faces.resize(1, 3);
  face.faces << 0, 1, 2;
  for (double along : {0.5, 0.3, 0.01, 0.0})
    for (double height : {1.0, 0.1, 0.02, 0.01, 0.007, 0.001, 1e-6, 0.0}) {
      face.vertices << 0, 0, 0, 1, 0, 0, along, height, 0;
      const Laplacian laplacian = cotangentLaplacian(face);
      EXPECT_GT(leastEigenvalue(laplacian), -1e-12) << along << " " << height;
      EXPECT_LT((laplacian.stiffness * Vector::Ones(3)).norm(), 1e-12);
    }
}

TEST(Laplacian, aNeedleDoesNotOutweighASurface) {
  TriangleMesh mesh = test::sphere(2);
  const int n = vertexCount(mesh), m = static_cast<int>(mesh.faces.rows());
  mesh.vertices.conservativeResize(n + 1, 3);
  mesh.vertices.row(n) = (1 - 1e-12) * mesh.vertices.row(mesh.faces(0, 0));
  mesh.faces.conservativeResize(m + 1, 3);
  mesh.faces.row(m) << mesh.faces(0, 0), mesh.faces(0, 1), n;
  const Laplacian laplacian = cotangentLaplacian(mesh);
  EXPECT_LT(Matrix(laplacian.stiffness).cwiseAbs().maxCoeff(), 200);
}

TEST(Laplacian, isFiniteOnDegenerateFacesAndVerticesInNone) {
  TriangleMesh mesh = test::grid(3, 3, 1, 1);
  const int n = vertexCount(mesh), m = static_cast<int>(mesh.faces.rows());
  mesh.vertices.conservativeResize(n + 3, 3);
  mesh.vertices.bottomRows(3) << 0, 0, 0, 2, 0, 0, 9, 9, 9;  // the first at the place of vertex 0
  mesh.faces.conservativeResize(m + 4, 3);
  // A corner twice; all corners at one vertex; two corners at one place; three on a line.
  mesh.faces.bottomRows(4) << 1, 1, 2, 5, 5, 5, 0, n, 1, 0, 1, n + 1;
  const Laplacian laplacian = cotangentLaplacian(mesh);
  EXPECT_TRUE(Matrix(laplacian.stiffness).allFinite());
  EXPECT_GT(laplacian.mass.minCoeff(), 0);
  EXPECT_NEAR(laplacian.mass.sum(), 1, 1e-5);
  EXPECT_LT((laplacian.stiffness * Vector::Ones(n + 3)).norm(), 1e-10);
  EXPECT_GT(leastEigenvalue(laplacian), -1e-10);
  EXPECT_EQ(Matrix(laplacian.stiffness).row(n + 2).norm(), 0);
}

}  // namespace
}  // namespace posture
