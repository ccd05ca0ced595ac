// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/reduce_mesh.h>
#include <posture/refine/bent_pair.h>
#include <posture/refine/conform.h>
#include <posture/refine/lay_over.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/bodies.h"
#include "support/shapes.h"
#include "support/unit_area.h"
#include <omp.h>

namespace posture {
namespace {

const Eigen::Matrix3d TURN =
    Eigen::AngleAxisd(2.4, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();

/// About 1000 vertices in farthest-point order, area about one.
TriangleMesh body(int pose) { return test::unitArea(test::body(pose, 2000).mesh); }

/// The faces of a mesh with all corners where `keep` holds, without the other vertices.
template <class Keep>
TriangleMesh part(const TriangleMesh& mesh, const Keep& keep, std::vector<int>& vertex) {
  TriangleMesh cut{{}, Faces(mesh.faces.rows(), 3)};
  std::vector<int> number(mesh.vertices.rows(), -1);
  int faces = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3i face = mesh.faces.row(f);
    if (!keep(face[0]) || !keep(face[1]) || !keep(face[2])) continue;
    for (int k = 0; k < 3; ++k) {
      if (number[face[k]] < 0) {
        number[face[k]] = static_cast<int>(vertex.size());
        vertex.push_back(face[k]);
      }
      cut.faces(faces, k) = number[face[k]];
    }
    ++faces;
  }
  cut.faces.conservativeResize(faces, 3);
  cut.vertices = mesh.vertices(vertex, Eigen::all);
  return cut;
}

TEST(Similarity, goesThereAndBack) {
  const Similarity way{1.7, TURN, {1, -2, 3}};
  const Points points = Points::Random(20, 3);
  EXPECT_LT((way.inverseOf(way.of(points)) - points).norm(), 1e-12);
  EXPECT_LT((way.of(points).row(3).transpose() -
             (1.7 * TURN * points.row(3).transpose() + Eigen::Vector3d(1, -2, 3)))
                .norm(),
            1e-12);
}

TEST(SurfacePlaces, areSpreadOverAllPiecesWhateverTheirOrder) {
  const TriangleMesh whole = body(0);
  std::vector<int> front_vertex, back_vertex;
  const TriangleMesh front = part(
      whole, [&](int v) { return whole.vertices(v, 0) > 0.1; }, front_vertex);
  const TriangleMesh back = part(
      whole, [&](int v) { return whole.vertices(v, 0) < -0.1; }, back_vertex);
  const SurfacePlaces places(test::joined(front, back)), other(test::joined(back, front));
  EXPECT_EQ(places.places, other.places);
  EXPECT_EQ(places.on_boundary, other.on_boundary);
  const auto in_front = (places.places.col(0).array() > 0).count();
  EXPECT_GT(in_front, places.places.rows() / 4);
  EXPECT_LT(in_front, places.places.rows() * 3 / 4);
}

TEST(LayOver, findsAnySimilarity) {
  const TriangleMesh mesh = reduceMesh(body(0), 1000).mesh;
  for (int i : {0, 2}) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.9 * i, Eigen::Vector3d(1, i, -2).normalized()).toRotationMatrix();
    const Similarity truth{1.15, turn, {3, 1, -2}};
    const auto ways =
        layOver(SurfacePlaces(mesh), SurfacePlaces({truth.of(mesh.vertices), mesh.faces}), 4);
    ASSERT_FALSE(ways.empty());
    EXPECT_NEAR(ways[0].scale, truth.scale, 1e-3);
    EXPECT_LT((ways[0].of(mesh.vertices) - truth.of(mesh.vertices)).rowwise().norm().mean(), 1e-3);
  }
}

TEST(LayOver, givesDifferentWaysByIncreasingCostAndNoMoreThanAskedFor) {
  const TriangleMesh a = reduceMesh(body(0), 1000).mesh, b = reduceMesh(body(3), 1000).mesh;
  const auto ways = layOver(SurfacePlaces(a), SurfacePlaces(b), 3);
  ASSERT_EQ(ways.size(), 3u);
  for (std::size_t i = 0; i < ways.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT((ways[i].of(a.vertices) - ways[j].of(a.vertices)).rowwise().norm().mean(), 0.05);
}

TEST(LayOver, isTheSameWithAnyNumberOfThreads) {
  const TriangleMesh a = reduceMesh(body(0), 600).mesh, b = reduceMesh(body(2), 600).mesh;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = layOver(SurfacePlaces(a), SurfacePlaces(b), 3);
  omp_set_num_threads(4);
  const auto four = layOver(SurfacePlaces(a), SurfacePlaces(b), 3);
  omp_set_num_threads(threads);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].scale, four[i].scale);
    EXPECT_EQ(one[i].rotation, four[i].rotation);
    EXPECT_EQ(one[i].translation, four[i].translation);
  }
}

TEST(LayOver, layAPieceSeenFromOneSideOnTheWholeBody) {
  const TriangleMesh whole = body(0);
  std::vector<int> vertex;
  const TriangleMesh side = part(
      whole, [&](int v) { return whole.vertices(v, 0) > 0.0; }, vertex);
  const TriangleMesh piece = reduceMesh({side.vertices * TURN.transpose(), side.faces}, 800).mesh;
  const auto ways = layOver(SurfacePlaces(piece), SurfacePlaces(reduceMesh(whole, 1000).mesh), 4);
  ASSERT_FALSE(ways.empty());
  const Points back = piece.vertices * TURN;
  EXPECT_LT((ways[0].of(piece.vertices) - back).rowwise().norm().mean(), 0.02);
}

TEST(Conform, bendsABodyOntoAnotherPose) {
  // The same triangulation: every vertex belongs to the one of its number.
  const TriangleMesh rest = body(0), posed = body(3);
  const BendableSurface a(rest), b(posed);
  const Similarity way = layOver(SurfacePlaces(rest), SurfacePlaces(posed), 1).front();
  const BendableSurface scaled({way.scale * rest.vertices, rest.faces});
  const Points laid = way.of(rest.vertices);
  const BentPair pair = conform(scaled, b, laid, way.scale * way.inverseOf(posed.vertices));
  const auto error = [&](const Points& places) {
    return (places - posed.vertices).rowwise().norm().mean();
  };
  const auto miss = [&](const Points& places) {
    return (places - posed.vertices(pair.maps.forward, Eigen::all)).rowwise().norm().mean();
  };
  // Far matches count little on purpose, so this goes part of the way; settling goes the rest.
  EXPECT_LT(error(pair.bent_a), error(laid));
  EXPECT_LT(miss(pair.bent_a), 0.7 * miss(laid));
  EXPECT_EQ(pair.maps.forward.size(), static_cast<std::size_t>(rest.vertices.rows()));
}

}  // namespace
}  // namespace posture
