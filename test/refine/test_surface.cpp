// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/reduce_mesh.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/refine/surface.h>
#include <posture/spectral/spectral_basis.h>

#include <gtest/gtest.h>

#include "refine/poses.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

TEST(BendableSurface, knowsWhatItsMeshSays) {
  const TriangleMesh mesh = test::bentStrip(12, 6, 2, 1, 1);
  const int n = static_cast<int>(mesh.vertices.rows());
  const BendableSurface surface(mesh);
  EXPECT_EQ(surface.mesh.vertices, mesh.vertices);
  EXPECT_EQ(surface.normals, vertexNormals(mesh));
  EXPECT_EQ(surface.on_boundary, boundaryVertices(mesh.faces, n));
  EXPECT_EQ(surface.laplacian.mass, cotangentLaplacian(mesh).mass);
  const VertexNeighbors neighbors(mesh.faces, n);
  for (int v = 0; v < n; ++v)
    EXPECT_TRUE(std::equal(neighbors.begin(v),
                           neighbors.end(v),
                           surface.neighbors.begin(v),
                           surface.neighbors.end(v)));
  const Points pulled = surface.arap.pull(mesh.vertices, mesh.vertices, surface.arap.attract(1), 1);
  EXPECT_LT(surface.arap.energy(pulled), 1e-12);
}

TEST(BendableSurface, marksHaveAnArea) {
  const BendableSurface strip(test::grid(10, 2, 10, 2));
  std::vector<char> marked(strip.mesh.vertices.rows(), 0);
  EXPECT_EQ(areaShare(strip, marked), 0);
  EXPECT_EQ(areaShare(strip, {}), 0);
  // Each vertex has a third of its faces: 2.5 of 10 at either end.
  for (int v = 0; v < strip.mesh.vertices.rows(); ++v)
    marked[v] = std::abs(strip.mesh.vertices(v, 0) - 5) > 2.5;
  EXPECT_NEAR(areaShare(strip, marked), 0.5, 1e-12);
}

TEST(SpectralSurface, functionsAreOrthonormalOnTheirOwnMesh) {
  const SpectralSurface surface = test::spectralSurface(test::bentStrip(20, 10, 2, 1, 1), 40);
  EXPECT_EQ(surface.functions.cols(), 40);
  EXPECT_LT((surface.gram - Eigen::MatrixXf::Identity(40, 40)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(SpectralSurface, takesFunctionsOfAFinerMesh) {
  const TriangleMesh fine = test::sphere(4);
  const SpectralBasis basis = spectralBasis(cotangentLaplacian(fine), 25);
  const ReducedMesh coarse = reduceMesh(fine, 500);
  Matrix functions(500, 25);
  for (int i = 0; i < 500; ++i) functions.row(i) = basis.functions.row(coarse.vertex[i]);
  const SpectralSurface surface(coarse.mesh, functions, basis.eigenvalues);
  // Inner products by 500 places instead of 2562, of waves of ten edges.
  EXPECT_LT((surface.gram - Eigen::MatrixXf::Identity(25, 25)).cwiseAbs().maxCoeff(), 0.1);
}

TEST(SpectralSurface, refusesFunctionsThatDoNotFit) {
  const TriangleMesh mesh = test::sphere(1);
  const auto n = mesh.vertices.rows();
  EXPECT_THROW(SpectralSurface(mesh, Matrix::Ones(n - 2, 3), Vector::Ones(3)),
               std::invalid_argument);
  EXPECT_THROW(SpectralSurface(mesh, Matrix::Ones(n, 3), Vector::Ones(2)), std::invalid_argument);
}

}  // namespace
}  // namespace posture
