// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "sides/cut_surface.h"
#include "support/shapes.h"
#include <algorithm>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// The clean vertices in a slice of a sphere.
std::vector<int> slice(const CleanMesh& clean, double from, double to) {
  std::vector<int> vertices;
  for (int v = 0; v < clean.mesh.vertices.rows(); ++v) {
    const double z = clean.mesh.vertices(v, 2);
    if (z > from && z < to) vertices.push_back(v);
  }
  return vertices;
}

/// Whether all faces of the input are made to look outward, those cut out as well.
void expectOutward(const TriangleMesh& input, const CleanMesh& clean) {
  const Faces faces = facedAlike(input.faces, clean);
  for (int f = 0; f < faces.rows(); ++f) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = input.vertices.row(faces(f, k)).transpose();
    EXPECT_GT(corners.determinant(), 0) << f;
  }
}

/// How many of the input's faces are left.
long facesLeft(const CleanMesh& clean) {
  return std::count(clean.face_on_main.begin(), clean.face_on_main.end(), 1);
}

TEST(CutSurface, tellsOfTheWholeInputAfterEachCut) {
  for (const bool inside_out : {false, true}) {
    TriangleMesh input = test::sphere(4);
    for (int f = 0; f < input.faces.rows(); ++f)
      if ((f % 20 == 0) != inside_out) std::swap(input.faces(f, 1), input.faces(f, 2));
    CutSurface cut(input, cleanMesh(input));
    ASSERT_EQ(cut.clean().inside_out, inside_out);
    ASSERT_TRUE(cut.cutOut(slice(cut.clean(), 0.8, 2)));
    EXPECT_EQ(cut.clean().inside_out, inside_out);
    expectOutward(input, cut.clean());
    const long after_one = facesLeft(cut.clean());
    EXPECT_EQ(after_one, cut.clean().mesh.faces.rows());
    EXPECT_LT(static_cast<double>(after_one), 0.95 * static_cast<double>(input.faces.rows()));
    // What was cut out before is not back, and the smaller part is a piece now.
    ASSERT_TRUE(cut.cutOut(slice(cut.clean(), 0.3, 0.5)));
    EXPECT_EQ(cut.clean().inside_out, inside_out);
    expectOutward(input, cut.clean());
    EXPECT_EQ(facesLeft(cut.clean()), cut.clean().mesh.faces.rows());
    EXPECT_LT(cut.clean().mesh.vertices.col(2).maxCoeff(), 0.35);
    EXPECT_GT(cut.clean().pieces.faces.rows(), 0);
    EXPECT_LT(cut.clean().pieces.vertices.col(2).maxCoeff(), 0.85);
  }
}

TEST(CutSurface, staysAsItIsWhereNothingWouldBeLeft) {
  const TriangleMesh input = test::sphere(3);
  CutSurface cut(input, cleanMesh(input));
  EXPECT_FALSE(cut.cutOut(slice(cut.clean(), -2, 2)));
  EXPECT_EQ(cut.clean().mesh.faces, cleanMesh(input).mesh.faces);
}

}  // namespace
}  // namespace posture
