// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/seams.h>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

/// Each face with corners of its own, in single precision, moved there and back in one of five
/// ways.
TriangleMesh roundedSoup(const TriangleMesh& mesh) {
  const auto m = mesh.faces.rows();
  TriangleMesh soup{Points(3 * m, 3), Faces(m, 3)};
  for (Eigen::Index f = 0; f < m; ++f)
    for (int k = 0; k < 3; ++k) {
      const auto shift = static_cast<float>(1 << (f % 5));
      const Eigen::RowVector3f there =
          (mesh.vertices.row(mesh.faces(f, k)).cast<float>().array() + shift).matrix();
      soup.vertices.row(3 * f + k) = (there.array() - shift).matrix().cast<double>();
      soup.faces(f, k) = static_cast<int>(3 * f + k);
    }
  return soup;
}

TEST(Seams, ofFacesWithCornersOfTheirOwnAreClosed) {
  const TriangleMesh ball = test::sphere(3);
  TriangleMesh soup = roundedSoup(ball);
  const Points before = soup.vertices;
  EXPECT_GT(cleanMesh(soup).summary.components, 10);
  EXPECT_GT(closeSeams(soup), 100);
  EXPECT_LT((soup.vertices - before).cwiseAbs().maxCoeff(), 1e-5);
  const CleanMesh clean = cleanMesh(soup);
  EXPECT_EQ(clean.mesh.vertices.rows(), ball.vertices.rows());
  EXPECT_EQ(clean.mesh.faces.rows(), ball.faces.rows());
  EXPECT_EQ(clean.summary.components, 1);
  EXPECT_EQ(closeSeams(soup), 0);
}

TEST(Seams, ofFacesListedTwiceAreClosed) {
  const TriangleMesh ball = test::sphere(2);
  TriangleMesh soup = roundedSoup(ball);
  const auto m = soup.faces.rows();
  soup.faces.conservativeResize(2 * m, 3);
  soup.faces.bottomRows(m) = soup.faces.topRows(m);
  soup.faces.bottomRows(m).col(0).swap(soup.faces.bottomRows(m).col(1));
  EXPECT_GT(closeSeams(soup), 0);
  EXPECT_EQ(cleanMesh(soup).mesh.vertices.rows(), ball.vertices.rows());
}

TEST(Seams, nothingElseMoves) {
  // Two sheets a fiftieth of an edge apart; a strip a thousandth of its length wide; a closed body.
  const TriangleMesh sheet = test::grid(6, 6, 6, 6);
  const TriangleMesh sheets = test::joined(sheet, test::shifted(sheet, {0, 0, 0.02}));
  for (TriangleMesh mesh : {sheets, test::grid(9, 1, 1, 1e-3), test::sphere(3)}) {
    const Points before = mesh.vertices;
    EXPECT_EQ(closeSeams(mesh), 0);
    EXPECT_EQ(mesh.vertices, before);
  }
}

}  // namespace
}  // namespace posture
