// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/colors.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <support/shapes.h>

namespace posture {
namespace {

double distance(const Colors& colors, Eigen::Index a, Eigen::Index b) {
  return (colors.row(a).cast<double>() - colors.row(b).cast<double>()).norm();
}

/// An ellipsoid: three axes of different length, everything mirrored in all of them.
TriangleMesh body() {
  TriangleMesh mesh = test::sphere(5);
  mesh.vertices *= Eigen::Vector3d(3, 2, 1).asDiagonal();
  return mesh;
}

TEST(PlaceColors, mirroredPlacesDiffer) {
  const TriangleMesh mesh = body();
  const Colors colors = placeColors(mesh.vertices);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); i += 16)
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(mesh.vertices(i, axis)) < 0.25 * (3 - axis)) continue;
      Eigen::RowVector3d mirrored = mesh.vertices.row(i);
      mirrored(axis) *= -1;
      Eigen::Index other = 0;
      (mesh.vertices.rowwise() - mirrored).rowwise().norm().minCoeff(&other);
      EXPECT_GT(distance(colors, i, other), 10) << mesh.vertices.row(i) << " in axis " << axis;
    }
}

TEST(PlaceColors, neighboursAreAlikeAndNothingIsGrey) {
  const TriangleMesh mesh = body();
  const Colors colors = placeColors(mesh.vertices);
  double sum = 0;
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    const double step = distance(colors, mesh.faces(f, 0), mesh.faces(f, 1));
    sum += step;
    EXPECT_LT(step, 60);
  }
  EXPECT_LT(sum / double(mesh.faces.rows()), 6);
  for (Eigen::Index i = 0; i < colors.rows(); ++i)
    EXPECT_NE(colors.row(i), Colors::Constant(1, 3, REJECTED_GREY).row(0));
}

TEST(PlaceColors, equalPlacesGetEqualColors) {
  const TriangleMesh mesh = body();
  const PlaceColoring coloring(mesh.vertices);
  const Colors colors = coloring(mesh.vertices);
  const Points few = mesh.vertices.topRows(10);
  EXPECT_EQ(coloring(few), colors.topRows(10));
}

TEST(PlaceColors, degenerateShapes) {
  EXPECT_EQ(placeColors(Points(0, 3)).rows(), 0);
  EXPECT_EQ(placeColors(Points::Ones(4, 3)).rows(), 4);
}

TEST(PlaceColors, whatWasNotSeenIsGreyAndChangesNoOther) {
  const TriangleMesh mesh = body();
  Points with_gap(mesh.vertices.rows() + 1, 3);
  with_gap << mesh.vertices.topRows(5),
      Eigen::RowVector3d(1, std::numeric_limits<double>::quiet_NaN(), 0),
      mesh.vertices.bottomRows(mesh.vertices.rows() - 5);
  const Colors whole = placeColors(mesh.vertices), colors = placeColors(with_gap);
  EXPECT_EQ(colors.topRows(5), whole.topRows(5));
  EXPECT_EQ(colors.row(5), Colors::Constant(1, 3, REJECTED_GREY).row(0));
  EXPECT_EQ(colors.bottomRows(whole.rows() - 5), whole.bottomRows(whole.rows() - 5));
}

Correspondence threePlaces() {
  Correspondence correspondence;
  correspondence.on_target = {{0, 0, {0.75, 0.25, 0}}, {}, {3, -1, {0, 0, 0}}};
  correspondence.confidence = Vector::Ones(3);
  return correspondence;
}

TEST(PlaceColors, whatLiesFarOffChangesNoOther) {
  const Points body_alone = body().vertices;
  Points with_outliers(body_alone.rows() + 2, 3);
  with_outliers << body_alone, Points::Constant(1, 3, 1e38), Points::Constant(1, 3, -100);
  EXPECT_EQ(placeColors(with_outliers).topRows(body_alone.rows()), placeColors(body_alone));
}

TEST(PlaceColors, whatIsMostlyAtOnePlaceStillHasItsColors) {
  Points points = Points::Zero(2000, 3);
  points.topRows(10) = test::randomPoints(10, 1);
  const Colors colors = placeColors(points);
  EXPECT_GT(distance(colors, 0, 1), 0);
  EXPECT_GT(distance(colors, 0, 11), 0);
}

TEST(TransferColors, byPlaceOnTheTarget) {
  const TriangleMesh target = test::grid(2, 1, 2, 1);
  Colors source(3, 3);
  source << 200, 0, 0, 0, 200, 0, 0, 0, 200;
  const Colors colors = transferColors(source, threePlaces(), target);
  ASSERT_EQ(colors.rows(), target.vertices.rows());
  EXPECT_EQ(colors.row(target.faces(0, 0)), source.row(0));
  EXPECT_EQ(colors.row(target.faces(0, 1)), source.row(0));
  EXPECT_EQ(colors.row(target.faces(0, 2)), Colors::Constant(1, 3, REJECTED_GREY).row(0));
}

TEST(TransferColors, pointsOfACloudTakeTheColorOfTheSurfaceThroughThem) {
  Colors source(3, 3);
  source << 200, 0, 0, 0, 200, 0, 0, 0, 200;
  ScanSurface scan;
  scan.mesh = test::grid(2, 1, 2, 1);
  scan.on_mesh = {{}, {scan.mesh.faces(0, 0), 0, {1, 0, 0}}, {3, 0, {0, 0, 1}}};
  Shape target;
  target.cloud.points = Points::Zero(3, 3);
  // The third place is a point of the cloud, in no face: it says nothing of the surface.
  const Colors colors = transferColors(source, threePlaces(), target, scan);
  ASSERT_EQ(colors.rows(), 3);
  EXPECT_EQ(colors.row(0), Colors::Constant(1, 3, REJECTED_GREY).row(0));
  EXPECT_EQ(colors.row(1), source.row(0));
  EXPECT_EQ(colors.row(2), Colors::Constant(1, 3, REJECTED_GREY).row(0));
}

TEST(TransferColors, meanOfAllAtAVertex) {
  Colors source(3, 3);
  source << 100, 0, 0, 201, 0, 50, 9, 9, 9;
  Correspondence correspondence;
  for (const int vertex : {1, 1, -1}) correspondence.on_target.push_back({vertex, -1, {0, 0, 0}});
  const Colors colors = transferColors(source, correspondence, test::grid(1, 1, 1, 1));
  EXPECT_EQ(colors(1, 0), 151);  // of 150.5
  EXPECT_EQ(colors(1, 2), 25);
  EXPECT_EQ(colors(0, 0), REJECTED_GREY);
  EXPECT_EQ(colors(2, 1), REJECTED_GREY);
}

TEST(TransferColors, misuseThrows) {
  const Colors source = Colors::Zero(3, 3);
  const TriangleMesh target = test::grid(1, 1, 1, 1);
  EXPECT_THROW(transferColors(Colors::Zero(2, 3), threePlaces(), target), std::invalid_argument);
  Correspondence beyond = threePlaces();
  beyond.on_target[0].face = 2;
  EXPECT_THROW(transferColors(source, beyond, target), std::invalid_argument);
  beyond = threePlaces();
  beyond.on_target[2].vertex = 4;
  EXPECT_THROW(transferColors(source, beyond, target), std::invalid_argument);
}

TEST(GreyWhereRejected, keepsTheOthers) {
  const Colors colors = greyWhereRejected(Colors::Zero(3, 3), threePlaces());
  EXPECT_EQ(colors(0, 0), 0);
  EXPECT_EQ(colors(1, 0), REJECTED_GREY);
  EXPECT_EQ(colors(2, 0), 0);
}

TEST(ErrorColors, fromDarkToBright) {
  Vector errors(5);
  errors << 0, 0.5, 1, 7, std::numeric_limits<double>::quiet_NaN();
  const Colors colors = errorColors(errors, 1);
  const Eigen::VectorXi brightness = colors.cast<int>().rowwise().sum();
  EXPECT_LT(brightness(0), brightness(1));
  EXPECT_LT(brightness(1), brightness(2));
  EXPECT_EQ(colors.row(2), colors.row(3));
  EXPECT_EQ(colors(4, 0), REJECTED_GREY);
  EXPECT_THROW(errorColors(errors, 0), std::invalid_argument);
}

TEST(PartPalette, partsThatTouchDiffer) {
  const TriangleMesh ball = test::sphere(4);
  std::vector<int> label(ball.vertices.rows());
  for (std::size_t v = 0; v < label.size(); ++v) {  // eight octants, of which three have no part
    const auto at = ball.vertices.row(static_cast<Eigen::Index>(v));
    label[v] = std::max(-1, (at[0] > 0) + 2 * (at[1] > 0) + 4 * (at[2] > 0) - 3);
  }
  const Colors palette = partPalette(6, label, ball.faces);
  ASSERT_EQ(palette.rows(), 6);  // one without a vertex among them
  for (Eigen::Index f = 0; f < ball.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = label[ball.faces(f, k)], b = label[ball.faces(f, (k + 1) % 3)];
      if (a >= 0 && b >= 0 && a != b) {
        EXPECT_GT(distance(palette, a, b), 60);
      }
    }
  EXPECT_THROW(partPalette(4, label, ball.faces), std::invalid_argument);
  const Colors colors = partColors(label, palette);
  for (std::size_t v = 0; v < label.size(); ++v) {
    const auto row = colors.row(static_cast<Eigen::Index>(v));
    if (label[v] < 0) {
      EXPECT_TRUE((row.array() == REJECTED_GREY).all());
    } else {
      EXPECT_EQ(row, palette.row(label[v]));
    }
  }
  EXPECT_THROW(partColors({6}, palette), std::invalid_argument);
}

}  // namespace
}  // namespace posture
