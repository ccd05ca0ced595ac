// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/place_piece.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <limits>
#include <stdexcept>
#include <vector>

namespace posture {
namespace {

/// A lump without any symmetry, about one across. Its points are those of finer and finer
/// icosahedra: any prefix is spread evenly, more or less.
Points lump() {
  Points points = test::sphere(3).vertices.topRows(300);
  for (auto p : points.rowwise())
    p = Eigen::RowVector3d(0.5 * p.x() + 0.2 * p.y() * p.y() + 0.1 * p.z(),
                           0.3 * p.y() + 0.1 * p.x() * p.z(),
                           0.2 * p.z() + 0.1 * p.x() * p.y());
  return points;
}

/// Of the points, those around the first one.
std::vector<int> partOf(const Points& points, double reach) {
  std::vector<int> part;
  for (int v = 0; v < points.rows(); ++v)
    if ((points.row(v) - points.row(0)).norm() < reach) part.push_back(v);
  return part;
}

/// A piece of a lump and its places, found once.
struct Placed {
  std::vector<int> part = partOf(lump(), 0.3);
  Matrix whole = test::pairwise(lump()), piece = whole(part, part);
  std::vector<PiecePlace> places = placePiece(piece, whole, 5);
};

const Placed& placed() {
  static const Placed once;
  return once;
}

TEST(PlacePiece, findsAPieceOfAnySizeWhereItCameFrom) {
  const std::vector<int>& part = placed().part;
  ASSERT_GT(part.size(), 30);
  ASSERT_LT(part.size(), 110);
  const auto expectFound = [&](const std::vector<PiecePlace>& places, double size) {
    ASSERT_FALSE(places.empty());
    EXPECT_EQ(places.front().sample, part);
    EXPECT_NEAR(places.front().scale * size, 1, 1e-9);
    EXPECT_LT(places.front().misfit, 1e-9);
  };
  expectFound(placed().places, 1);
  expectFound(placePiece(2.6 * placed().piece, placed().whole, 3), 2.6);
}

TEST(PlacePiece, ranksDifferentPlacesByMisfit) {
  const std::vector<PiecePlace>& places = placed().places;
  ASSERT_GT(places.size(), 1);
  ASSERT_LE(places.size(), 5);
  for (std::size_t i = 1; i < places.size(); ++i) {
    EXPECT_GE(places[i].misfit, places[i - 1].misfit);
    EXPECT_NE(places[i].sample, places[0].sample);
  }
  EXPECT_GT(places[1].misfit, 0.01);
}

TEST(PlacePiece, ofFewSamplesAsWellNoTwoPlacesAreOne) {
  // All of the whole's samples may be anchors: how close they are tells what is one place.
  const Points whole = lump().topRows(80);
  const Matrix distances = test::pairwise(whole);
  const double spacing = distances.row(79).head(79).minCoeff();
  const std::vector<int> part = partOf(whole, 0.4);
  ASSERT_GT(part.size(), 15);
  const std::vector<PiecePlace> places =
      placePiece(test::pairwise(whole(part, Eigen::all)), distances, 12);
  ASSERT_GT(places.size(), 1);
  EXPECT_EQ(places.front().sample, part);
  for (std::size_t i = 1; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double apart = 0;
      for (std::size_t k = 0; k < part.size(); ++k)
        apart += distances(places[i].sample[k], places[j].sample[k]);
      EXPECT_GE(apart / static_cast<double>(part.size()), 2 * spacing) << i << " " << j;
    }
}

TEST(PlacePiece, fitsNoLongLineIntoABall) {
  Points line = Points::Zero(40, 3);
  for (int i = 0; i < 40; ++i) line(i, 0) = 0.5 * (7 * i % 40);
  const std::vector<PiecePlace> places =
      placePiece(test::pairwise(line), test::pairwise(test::sphere(2).vertices), 3);
  ASSERT_FALSE(places.empty());
  for (const PiecePlace& place : places) EXPECT_GT(place.misfit, 0.1);
}

TEST(PlacePiece, refusesTablesItCannotUse) {
  EXPECT_THROW(placePiece(Matrix::Zero(3, 3), Matrix::Zero(9, 9), 1), std::invalid_argument);
  EXPECT_THROW(placePiece(Matrix::Zero(9, 8), Matrix::Zero(9, 9), 1), std::invalid_argument);
  EXPECT_THROW(placePiece(Matrix::Zero(9, 9), Matrix::Ones(9, 9), 1), std::invalid_argument);
  Matrix apart = Matrix::Ones(9, 9);
  apart(2, 5) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(placePiece(Matrix::Ones(9, 9), apart, 1), std::invalid_argument);
}

}  // namespace
}  // namespace posture
