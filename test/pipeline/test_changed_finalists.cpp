// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "refine/club.h"
#include "refined/finalists/changed_finalists.h"
#include "refined/work/refined_shape.h"
#include "support/shapes.h"
#include "support/unit_area.h"
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// An ellipsoid with three different axes, which is its own copy when turned by half about any of
/// them, perhaps with a bump that is beside all three.
RefinedShape ellipsoid(double bump) {
  TriangleMesh mesh = test::sphere(4);
  const Eigen::RowVector3d top = Eigen::RowVector3d(1, 0.8, 0.6).normalized();
  for (auto place : mesh.vertices.rowwise())
    place *= 1 + bump * std::exp(-(place - top).squaredNorm() / (0.3 * 0.3));
  mesh.vertices.array().rowwise() *= Eigen::Array<double, 1, 3>(1, 0.75, 0.5);
  mesh = test::unitArea(std::move(mesh));
  RefinedShape shape = fullSide("ellipsoid", mesh, false);
  reduceSide("source", static_cast<int>(mesh.vertices.rows()), shape);
  addSpectrum("side", shape);
  addSamples("body", shape);
  return shape;
}

/// Where vertices go when the mesh is turned by half about an axis.
std::vector<int> turned(const TriangleMesh& mesh, int axis) {
  Points places = -mesh.vertices;
  places.col(axis) *= -1;
  return test::nearestOf(places, mesh);
}

/// How far two maps are apart, in edges.
double gap(const TriangleMesh& mesh, const std::vector<int>& x, const std::vector<int>& y) {
  const Points at_x = mesh.vertices(x, Eigen::all), at_y = mesh.vertices(y, Eigen::all);
  return (at_x - at_y).rowwise().norm().mean() / meanEdgeLength(mesh);
}

TEST(TurnsOntoItself, areThoseOfTheBodyAndKeepTheOutsideOut) {
  const RefinedShape shape = ellipsoid(0);
  const SpectralSurface surface = shape.coarseSurface();
  const std::vector<VertexMaps> turns = turnsOntoItself(surface, shape.samples);
  ASSERT_EQ(turns.size(), 3U);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<int> known = turned(surface.mesh, axis);
    const auto nearest =
        std::min_element(turns.begin(), turns.end(), [&](const auto& x, const auto& y) {
          return gap(surface.mesh, known, x.forward) < gap(surface.mesh, known, y.forward);
        });
    EXPECT_LT(gap(surface.mesh, known, nearest->forward), 0.5) << "about axis " << axis;
    EXPECT_LT(gap(surface.mesh, known, nearest->backward), 0.5) << "about axis " << axis;
  }
}

TEST(WithTurned, aMapThatIsHalfATurnOffIsTurnedBack) {
  const RefinedShape shape = ellipsoid(0.3);
  const SpectralSurface surface = shape.coarseSurface();
  const std::vector<VertexMaps> turns = turnsOntoItself(surface, shape.samples);
  const std::vector<int> own = test::nearestOf(surface.mesh.vertices, surface.mesh);
  for (int axis = 0; axis < 3; ++axis) {
    Finalist wrong;
    wrong.orientation = 1;
    wrong.maps = {turned(surface.mesh, axis), turned(surface.mesh, axis)};
    wrong.score = scoreMaps(surface, surface, wrong.maps);
    ASSERT_GT(gap(surface.mesh, own, wrong.maps.forward), 8);
    for (const Turns& of_one : {Turns{turns, {}}, Turns{{}, turns}}) {
      const std::vector<Finalist> found =
          withTurned(surface, surface, of_one, {0}, 2 * shape.samples.spacing, {wrong});
      ASSERT_GT(found.size(), 1U);
      EXPECT_LT(gap(surface.mesh, own, found.front().maps.forward), 3);  // it is smooth all over
      EXPECT_LT(gap(surface.mesh, own, found.front().maps.backward), 3);
      EXPECT_LT(found.front().score.total(), wrong.score.total() - 1);
    }
  }
}

}  // namespace
}  // namespace posture
