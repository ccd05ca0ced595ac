// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/normals.h>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files.h"
#include "support/shapes.h"
#include <cmath>
#include <limits>
#include <stdexcept>

namespace posture {
namespace {

using test::joined;
using test::shifted;

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(f, 0));
    const Eigen::RowVector3d b = mesh.vertices.row(mesh.faces(f, 1));
    const Eigen::RowVector3d c = mesh.vertices.row(mesh.faces(f, 2));
    sum += a.dot(b.cross(c)) / 6;
  }
  return sum;
}

/// Without the faces whose first corner is farther along x or z than that.
TriangleMesh below(TriangleMesh mesh, const Eigen::Vector2d& most) {
  int kept = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d corner = mesh.vertices.row(mesh.faces(f, 0));
    if (corner.x() <= most.x() && corner.z() <= most.y())
      mesh.faces.row(kept++) = mesh.faces.row(f).eval();
  }
  mesh.faces.conservativeResize(kept, 3);
  return mesh;
}

TEST(CleanMesh, leavesACleanMeshAsItIs) {
  const TriangleMesh sphere = test::sphere(2);
  const CleanMesh clean = cleanMesh(sphere);
  EXPECT_EQ(clean.mesh.vertices, sphere.vertices);
  EXPECT_EQ(clean.mesh.faces, sphere.faces);
  for (int v = 0; v < sphere.vertices.rows(); ++v) {
    EXPECT_EQ(clean.clean_vertex[v], v);
    EXPECT_EQ(clean.input_vertex[v], v);
  }
  EXPECT_EQ(clean.summary.components, 1);
}

TEST(CleanMesh, isThatOfTheMainSurfaceWhereverTheRestLies) {
  // At a map's coordinates, with a vertex in no face and a speck of a face at the origin.
  TriangleMesh mesh = test::sphere(2);
  const auto n = mesh.vertices.rows(), m = mesh.faces.rows();
  mesh.vertices.rowwise() += Eigen::RowVector3d(5e5, 5e6, 300);
  mesh.vertices.conservativeResize(n + 4, 3);
  mesh.vertices.bottomRows(4) << 0, 0, 0, 1, 0, 0, 1.1, 0, 0, 1, 0.1, 0;
  mesh.faces.conservativeResize(m + 1, 3);
  mesh.faces.bottomRows(1) << n + 1, n + 2, n + 3;
  const CleanMesh clean = cleanMesh(mesh);
  EXPECT_EQ(clean.mesh.vertices.rows(), n);
  EXPECT_EQ(clean.mesh.faces.rows(), m);
}

TEST(CleanMesh, refusesFacesInALineFarFromTheOrigin) {
  TriangleMesh line;
  line.vertices.resize(6, 3);
  for (int v = 0; v < 6; ++v)
    line.vertices.row(v) =
        Eigen::RowVector3d(5e5, 5e6, 300) + v * Eigen::RowVector3d(0.1, 0.7, 0.3);
  line.faces.resize(4, 3);
  line.faces << 0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 5;
  EXPECT_THROW(cleanMesh(line), InputError);
}

TEST(CleanMesh, loosePartsFollowTheSurfaceTheyAreNearestTo) {
  TriangleMesh eye = test::sphere(0);
  eye.vertices *= 0.1;
  const TriangleMesh head = test::sphere(3);
  const CleanMesh clean = cleanMesh(joined(eye, head));
  EXPECT_EQ(clean.summary.components, 2);
  EXPECT_EQ(clean.summary.loose_vertices, eye.vertices.rows());
  EXPECT_EQ(clean.mesh.vertices.rows(), head.vertices.rows());
  for (int v = 0; v < eye.vertices.rows(); ++v) {
    const Eigen::RowVector3d at = clean.mesh.vertices.row(clean.clean_vertex[v]);
    EXPECT_NEAR(clean.offset[v], (at - eye.vertices.row(v)).norm(), 1e-6);
    // The nearest head vertex lies out along the eye vertex's direction.
    EXPECT_GT(at.dot(eye.vertices.row(v).normalized()), 0.95);
  }
}

TEST(CleanMesh, keepsPiecesThatAreNoCrumbs) {
  const TriangleMesh ball = test::sphere(2);
  // One of a quarter of its area, turned inside out, and one of a ten-thousandth.
  TriangleMesh half = ball, crumb = ball;
  half.vertices *= 0.5;
  half.faces.col(0).swap(half.faces.col(1));
  crumb.vertices *= 0.01;
  const TriangleMesh mesh =
      joined(joined(ball, shifted(half, {3, 0, 0})), shifted(crumb, {0, 3, 0}));
  const CleanMesh clean = cleanMesh(mesh);
  ASSERT_EQ(clean.pieces.vertices.rows(), half.vertices.rows());
  EXPECT_EQ(clean.pieces.faces.rows(), half.faces.rows());
  ASSERT_EQ(clean.piece_vertex.size(), static_cast<std::size_t>(half.vertices.rows()));
  for (int v = 0; v < half.vertices.rows(); ++v)
    EXPECT_EQ(clean.pieces.vertices.row(v), mesh.vertices.row(clean.piece_vertex[v]));
  EXPECT_GT(volume(clean.pieces), 0);
}

TEST(CleanMesh, everyInputVertexHasAPlace) {
  TriangleMesh mesh = test::grid(4, 4, 1, 1);
  const int n = static_cast<int>(mesh.vertices.rows());
  mesh.vertices.conservativeResize(n + 2, 3);
  mesh.vertices.row(n) = mesh.vertices.row(7);  // the same place, in no face
  mesh.vertices.row(n + 1) << 0.5, 0.5, 3;      // in no face
  const CleanMesh clean = cleanMesh(mesh);
  EXPECT_EQ(clean.summary.unreferenced_vertices, 2);
  EXPECT_EQ(clean.summary.loose_vertices, 0);
  EXPECT_EQ(clean.clean_vertex[n], clean.clean_vertex[7]);
  EXPECT_EQ(clean.offset[n], 0);
  EXPECT_NEAR(clean.offset[n + 1], 3, 1e-6);
  EXPECT_EQ(clean.clean_vertex[n + 1], 12);
}

TEST(CleanMesh, weldsTheTriangleSoupOfAnStlFile) {
  const TriangleMesh sphere = test::sphere(1);
  const CleanMesh clean = cleanMesh(test::soup(sphere));
  EXPECT_EQ(clean.mesh.vertices.rows(), sphere.vertices.rows());
  EXPECT_EQ(clean.mesh.faces.rows(), sphere.faces.rows());
  EXPECT_EQ(clean.summary.components, 1);
  EXPECT_NEAR(volume(clean.mesh), volume(sphere), 1e-12);
}

TEST(CleanMesh, dropsDegenerateAndRepeatedFaces) {
  TriangleMesh mesh = test::sphere(1);
  const int m = static_cast<int>(mesh.faces.rows());
  mesh.faces.conservativeResize(m + 3, 3);
  mesh.faces.row(m) = mesh.faces.row(0);
  mesh.faces.row(m + 1) << mesh.faces(1, 1), mesh.faces(1, 0), mesh.faces(1, 2);
  mesh.faces.row(m + 2) << 3, 3, 5;
  const CleanMesh clean = cleanMesh(mesh);
  EXPECT_EQ(clean.mesh.faces.rows(), m);
  EXPECT_EQ(clean.summary.repeated_faces, 2);
  EXPECT_EQ(clean.summary.degenerate_faces, 1);
}

TEST(CleanMesh, orientsAClosedSurfaceOutwardsWhateverItsFacesSay) {
  const TriangleMesh sphere = test::sphere(2);
  TriangleMesh mixed = sphere;
  for (int f = 0; f < mixed.faces.rows(); ++f)
    if (f % 3 != 0) std::swap(mixed.faces(f, 1), mixed.faces(f, 2));
  const CleanMesh clean = cleanMesh(mixed);
  EXPECT_NEAR(volume(clean.mesh), volume(sphere), 1e-12);
  EXPECT_EQ(clean.summary.flipped_faces, mixed.faces.rows() - (mixed.faces.rows() + 2) / 3);
}

TEST(CleanMesh, orientsAnOpenSurfaceTheWayMostOfItFaces) {
  TriangleMesh mesh = test::grid(6, 6, 1, 1);
  std::swap(mesh.faces(5, 0), mesh.faces(5, 1));
  const CleanMesh clean = cleanMesh(mesh);
  EXPECT_EQ(clean.summary.flipped_faces, 1);
  for (int f = 0; f < clean.mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d a = clean.mesh.vertices.row(clean.mesh.faces(f, 0));
    const Eigen::RowVector3d b = clean.mesh.vertices.row(clean.mesh.faces(f, 1));
    const Eigen::RowVector3d c = clean.mesh.vertices.row(clean.mesh.faces(f, 2));
    EXPECT_GT((b - a).cross(c - a).z(), 0);
  }
}

TEST(CleanMesh, turnsASurfaceOutwardsThatIsClosedButForSmallHoles) {
  TriangleMesh ball = below(test::sphere(4), {0.8, 0.9});
  ball.faces.col(0).swap(ball.faces.col(1));
  const CleanMesh clean = cleanMesh(ball);
  EXPECT_TRUE(clean.outward_known);
  EXPECT_TRUE(clean.inside_out);
  EXPECT_GT(volume(clean.mesh), 1);
  EXPECT_EQ(clean.summary.flipped_faces, ball.faces.rows());
  EXPECT_THAT(clean.face_on_main, testing::Each(1));
  EXPECT_THAT(clean.face_turned, testing::Each(1));
  Faces right = ball.faces;
  right.col(1).swap(right.col(2));
  EXPECT_EQ(facedAlike(ball.faces, clean), right);
  EXPECT_THROW(facedAlike(ball.faces.topRows(9), clean), std::invalid_argument);
  EXPECT_LT(volume(cleanMesh(ball, Facing::AS_MOST).mesh), -1);
}

TEST(CleanMesh, takesNothingForInsideOutWhereFacesWereGivenEveryWhichWay) {
  TriangleMesh ball = below(test::sphere(4), {0.8, 0.9});
  for (int f = 0; f < ball.faces.rows(); ++f)
    if (f % 5 > 1) std::swap(ball.faces(f, 1), ball.faces(f, 2));
  const CleanMesh clean = cleanMesh(ball);
  EXPECT_TRUE(clean.outward_known);
  EXPECT_FALSE(clean.inside_out);
  EXPECT_GT(volume(clean.mesh), 1);
}

TEST(CleanMesh, doesNotTellTheOutsideOfTwoLayers) {
  // A flat bag, open along one side: its volume means nothing.
  const TriangleMesh sheet = test::grid(8, 8, 1, 1);
  TriangleMesh back = sheet;
  back.faces.col(0).swap(back.faces.col(1));
  TriangleMesh bag = joined(sheet, shifted(back, {0, 0, -1e-3}));
  const auto n = sheet.vertices.rows();
  const Eigen::RowVector3d far = sheet.vertices.colwise().maxCoeff();
  for (Eigen::Index v = 0; v < n; ++v) {
    const double x = sheet.vertices(v, 0), y = sheet.vertices(v, 1);
    if (x == far.x() || y == 0 || y == far.y()) bag.vertices(n + v, 2) = 0;
  }
  bag.faces.col(0).swap(bag.faces.col(1));
  const CleanMesh clean = cleanMesh(bag);
  ASSERT_EQ(clean.mesh.faces.rows(), bag.faces.rows());
  ASSERT_LT(volume(clean.mesh), 0);
  EXPECT_FALSE(clean.outward_known);
  EXPECT_EQ(clean.summary.flipped_faces, 0);
}

TEST(CleanMesh, leavesAShellTheWayItFaces) {
  // Half a sphere: its lid has half its area.
  TriangleMesh shell = below(test::sphere(4), {1.0, 0.0});
  shell.faces.col(0).swap(shell.faces.col(1));
  const CleanMesh clean = cleanMesh(shell);
  EXPECT_FALSE(clean.outward_known);
  EXPECT_FALSE(clean.inside_out);
  EXPECT_EQ(clean.mesh.faces.rows(), shell.faces.rows());
  EXPECT_LT(volume(clean.mesh), 0);
}

TEST(CleanMesh, turnsPiecesThatDoNotTellTheWayTheMainSurfaceWasTurned) {
  const TriangleMesh sphere = test::sphere(3), shell = below(sphere, {1.0, 0.0});
  TriangleMesh all =
      joined(joined(sphere, shifted(shell, {4, 0, 0})), shifted(test::sphere(2), {8, 0, 0}));
  all.vertices.topRows(sphere.vertices.rows()) *= 2;
  TriangleMesh inside_out = all;
  inside_out.faces.col(0).swap(inside_out.faces.col(1));
  const CleanMesh right = cleanMesh(all), mended = cleanMesh(inside_out);
  ASSERT_GT(right.pieces.faces.rows(), 0);
  EXPECT_GT(volume(right.mesh), 0);
  EXPECT_NEAR(volume(mended.mesh), volume(right.mesh), 1e-12);
  EXPECT_NEAR(volume(mended.pieces), volume(right.pieces), 1e-9);
  CleanMesh turned = right;
  turnOver(turned);
  EXPECT_NEAR(volume(turned.mesh), -volume(right.mesh), 1e-12);
  EXPECT_TRUE(turned.inside_out);
  // The shell looks the other way, the ball beside it does not.
  const Points outward = vertexNormals(right.pieces), after = vertexNormals(turned.pieces);
  int changed = 0;
  for (int v = 0; v < after.rows(); ++v) {
    const bool of_shell = right.pieces.vertices(v, 0) < 6;
    EXPECT_EQ(outward.row(v).dot(after.row(v)) < 0, of_shell);
    changed += of_shell;
  }
  EXPECT_GT(changed, 0);
}

TEST(CleanMesh, keepsNonManifoldEdgesAndCountsThem) {
  TriangleMesh mesh;
  mesh.vertices.resize(5, 3);
  mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1;
  mesh.faces.resize(3, 3);
  mesh.faces << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  const CleanMesh clean = cleanMesh(mesh);
  EXPECT_EQ(clean.summary.non_manifold_edges, 1);
  EXPECT_EQ(clean.mesh.faces.rows(), 3);
}

TEST(CleanMesh, refusesMeshesWithoutSurface) {
  TriangleMesh cloud;
  cloud.vertices = Points::Random(10, 3);
  cloud.faces.resize(0, 3);
  EXPECT_THROW(cleanMesh(cloud), InputError);
  TriangleMesh collapsed = test::sphere(0);
  collapsed.vertices.setZero();
  EXPECT_THROW(cleanMesh(collapsed), InputError);
  for (const double unit : {1e-15, 1.0, 1e15}) {
    TriangleMesh line = test::grid(9, 4, 1, 1);
    const Eigen::RowVector3d along(0.3, 0.7, -0.2);
    for (int v = 0; v < line.vertices.rows(); ++v) line.vertices.row(v) = 0.1 * v * unit * along;
    EXPECT_THROW(cleanMesh(line), InputError) << unit;
    TriangleMesh strip = test::grid(9, 1, 1, 1e-3);
    strip.vertices *= unit;
    EXPECT_NO_THROW(cleanMesh(strip)) << unit;
  }
}

TEST(CleanMesh, refusesUnitsThatItCannotMeasureIn) {
  const TriangleMesh sphere = test::sphere(2);
  TriangleMesh mesh = sphere;
  const auto refusal = [&] { return test::inputErrorOf([&] { cleanMesh(mesh); }); };
  for (const double unit : {1e-300, 1e-150, 1e-60, 1e-20}) {
    mesh.vertices = unit * sphere.vertices;
    EXPECT_EQ(refusal(), "is too small to compute with") << unit;
  }
  for (const double unit : {1e60, 1e150, 1e300}) {
    mesh.vertices = unit * sphere.vertices;
    EXPECT_EQ(refusal(), "has coordinates too large to compute with") << unit;
  }
  mesh.vertices = 1e20 * sphere.vertices;
  EXPECT_EQ(refusal(), "is too large to compute with");
  for (const double unit : {1e-17, 1e17}) {
    mesh.vertices = unit * sphere.vertices;
    EXPECT_NO_THROW(cleanMesh(mesh)) << unit;
  }
}

TEST(CleanMesh, countsPointsInNoFaceAmongTheCoordinates) {
  TriangleMesh mesh = test::sphere(2);
  mesh.vertices.conservativeResize(mesh.vertices.rows() + 1, 3);
  mesh.vertices.bottomRows(1) << 1.7e308, -1.7e308, 0;
  EXPECT_EQ(test::inputErrorOf([&] { cleanMesh(mesh); }),
            "has coordinates too large to compute with");
  mesh.vertices.bottomRows(1) << 3.4e38, -3.4e38, 0;
  EXPECT_EQ(cleanMesh(mesh).summary.unreferenced_vertices, 1);
}

TEST(CleanMesh, facesOfAPieceAreTurnedAsThePieceIsOriented) {
  TriangleMesh small = test::sphere(2);
  small.vertices *= 0.4;
  TriangleMesh mixed = joined(test::sphere(2), shifted(small, {5, 0, 0}));
  const auto n = small.faces.rows();
  // The piece is inside out, but for some faces; the main surface has a face turned, too.
  for (Eigen::Index f = n; f < 2 * n; ++f)
    if (f % 7 != 0) mixed.faces.row(f).reverseInPlace();
  mixed.faces.row(3).reverseInPlace();
  CleanMesh clean = cleanMesh(mixed);
  const double all = volume(test::sphere(2)) + volume(small);
  EXPECT_NEAR(volume({mixed.vertices, facedAlike(mixed.faces, clean)}), all, 1e-9);
  for (Eigen::Index f = n; f < 2 * n; ++f) EXPECT_EQ(clean.face_turned[f], f % 7 != 0) << f;
  // A closed piece tells its outside itself.
  turnOver(clean);
  EXPECT_NEAR(volume({mixed.vertices, facedAlike(mixed.faces, clean)}),
              volume(small) - volume(test::sphere(2)),
              1e-9);
}

TEST(CleanMesh, aSeamTooFineForSinglePrecisionIsOffTheMainSurface) {
  TriangleMesh mesh = test::sphere(2);
  const int n = static_cast<int>(mesh.vertices.rows());
  mesh.vertices.conservativeResize(n + 3, 3);
  mesh.vertices.bottomRows(3) = mesh.vertices.topRows(3).array() + 1e-12;
  mesh.faces.conservativeResize(mesh.faces.rows() + 1, 3);
  mesh.faces.bottomRows(1) << n, n + 1, n + 2;
  const CleanMesh clean = cleanMesh(mesh);
  for (int v = n; v < n + 3; ++v) EXPECT_GT(clean.offset[v], 0);
}

TEST(CleanMesh, refusesWhatIsNoMesh) {
  for (const int corner : {-1, 1000000}) {
    TriangleMesh mesh = test::sphere(1);
    mesh.faces(3, 1) = corner;
    EXPECT_THROW(cleanMesh(mesh), std::invalid_argument) << corner;
  }
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = test::sphere(1);
    mesh.vertices(5, 2) = bad;
    EXPECT_THROW(cleanMesh(mesh), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace posture
