// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/mean_value_encoding.h>
#include <posture/io/mesh_io.h>
#include <posture/mesh/clean_mesh.h>

#include <gtest/gtest.h>

#include "support/benchmark.h"
#include "support/motions.h"
#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

using test::moved;
using test::similarity;

TriangleMesh meshOf(std::initializer_list<Eigen::RowVector3d> vertices,
                    std::initializer_list<Eigen::RowVector3i> faces) {
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<int>(vertices.size()), 3);
  mesh.faces.resize(static_cast<int>(faces.size()), 3);
  int row = 0;
  for (const auto& v : vertices) mesh.vertices.row(row++) = v;
  row = 0;
  for (const auto& f : faces) mesh.faces.row(row++) = f;
  return mesh;
}

/// A hexagon of radius 1 and a vertex at a height over its centre.
TriangleMesh tent(double height) {
  TriangleMesh mesh;
  mesh.vertices.resize(7, 3);
  mesh.faces.resize(6, 3);
  for (int k = 0; k < 6; ++k) {
    mesh.vertices.row(k) << std::cos(k * M_PI / 3), std::sin(k * M_PI / 3), 0;
    mesh.faces.row(k) << k, (k + 1) % 6, 6;
  }
  mesh.vertices.row(6) << 0, 0, height;
  return mesh;
}

TriangleMesh bumpy() {
  TriangleMesh mesh = test::sphere(2);
  mesh.vertices += 0.05 * test::randomPoints(static_cast<int>(mesh.vertices.rows()), 5);
  return mesh;
}

/// A sheet folded onto itself along its middle: rings on the fold enclose no area.
TriangleMesh folded() {
  TriangleMesh mesh = test::grid(8, 5, 2, 1);
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    if (mesh.vertices(v, 0) > 1) mesh.vertices(v, 0) = 2 - mesh.vertices(v, 0);
  return mesh;
}

TriangleMesh withDent(TriangleMesh mesh) {
  mesh.vertices.row(20) += Eigen::RowVector3d(0.3, 0.2, 0.25);
  return mesh;
}

TriangleMesh twoParts() { return test::joined(bumpy(), withDent(test::bentStrip(10, 5, 2, 1, 2))); }

/// Three faces on one edge.
TriangleMesh book() {
  return meshOf({{0, 0, 0}, {0, 0, 1}, {1, 0, 0.4}, {-1, 0.5, 0.5}, {-0.5, -1, 0.6}},
                {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}});
}

std::vector<TriangleMesh> shapes() {
  return {bumpy(),
          test::sphere(1),
          tent(0.4),
          test::grid(6, 4, 2, 1),
          withDent(test::grid(8, 5, 2, 1)),
          withDent(test::bentStrip(10, 5, 2, 1, 2)),
          folded(),
          book(),
          twoParts()};
}

std::vector<Eigen::Vector3d> cornersOf(const MeanValueEncoding& encoding,
                                       int v,
                                       const Points& places) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = encoding.first[v]; i < encoding.first[v + 1]; ++i)
    corners.emplace_back(places.row(encoding.corner[i]));
  return corners;
}

Points rows(const Points& points, const std::vector<int>& which) {
  Points chosen(which.size(), 3);
  for (std::size_t i = 0; i < which.size(); ++i) chosen.row(i) = points.row(which[i]);
  return chosen;
}

double gap(const Points& x, const Points& y) { return (x - y).rowwise().norm().maxCoeff(); }

TEST(MeanValueEncoding, ofARegularTentIsKnown) {
  for (double height : {0.0, 0.4, -2.0}) {
    const MeanValueEncoding encoding = encodeMeanValues(tent(height));
    ASSERT_EQ(encoding.first[7] - encoding.first[6], 6);
    for (int i = encoding.first[6]; i < encoding.first[7]; ++i)
      EXPECT_NEAR(encoding.weight[i], 1.0 / 6, 1e-12);
    // The faces run counter-clockwise seen from above, and the hexagon's radius is 1.
    EXPECT_NEAR(encoding.offset[6], height, 1e-12);
  }
}

TEST(MeanValueEncoding, weightsAreFloaters) {
  // Floater 2003, equation 2.1, for a vertex off the centre of a square.
  const TriangleMesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.3, 0.4, 0}},
                                   {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const auto corner = [&](int k) {
    return Eigen::Vector3d(mesh.vertices.row(k % 4) - mesh.vertices.row(4));
  };
  const auto half_tangent = [&](int k) {
    return std::tan(0.5 * std::acos(corner(k).normalized().dot(corner(k + 1).normalized())));
  };
  Eigen::Vector4d expected;
  for (int k = 0; k < 4; ++k)
    expected[k] = (half_tangent(k + 3) + half_tangent(k)) / corner(k).norm();
  expected /= expected.sum();
  const MeanValueEncoding encoding = encodeMeanValues(mesh);
  ASSERT_EQ(encoding.first[5] - encoding.first[4], 4);
  for (int i = encoding.first[4]; i < encoding.first[5]; ++i)
    EXPECT_NEAR(encoding.weight[i], expected[encoding.corner[i]], 1e-12);
}

TEST(MeanValueEncoding, holdsForTheShapeItIsOf) {
  for (const TriangleMesh& mesh : shapes()) {
    const MeanValueEncoding encoding = encodeMeanValues(mesh);
    ASSERT_EQ(encoding.vertexCount(), mesh.vertices.rows());
    for (int v = 0; v < mesh.vertices.rows(); ++v) {
      double sum = 0;
      for (int i = encoding.first[v]; i < encoding.first[v + 1]; ++i) {
        sum += encoding.weight[i];
        EXPECT_NE(encoding.corner[i], v);
      }
      EXPECT_NEAR(sum, 1, 1e-12);
      const auto residual = meanValueResidual(
          encoding, v, mesh.vertices.row(v), cornersOf(encoding, v, mesh.vertices), false);
      EXPECT_LT(residual.value.norm(), 1e-12);
    }
  }
}

TEST(MeanValueEncoding, isThatOfAnySimilarShape) {
  for (const TriangleMesh& mesh : shapes()) {
    const MeanValueEncoding once = encodeMeanValues(mesh);
    const MeanValueEncoding again = encodeMeanValues(moved(mesh, similarity()));
    EXPECT_EQ(once.first, again.first);
    EXPECT_EQ(once.corner, again.corner);
    EXPECT_LT((once.offset - again.offset).cwiseAbs().maxCoeff(), 1e-10);
    for (std::size_t i = 0; i < once.weight.size(); ++i)
      EXPECT_NEAR(once.weight[i], again.weight[i], 1e-10);
    ASSERT_EQ(once.layout.size(), again.layout.size());
    for (std::size_t i = 0; i < once.layout.size(); ++i) {
      EXPECT_EQ(once.layout[i].vertex, again.layout[i].vertex);
      EXPECT_LT((once.layout[i].place - again.layout[i].place).norm(), 1e-9);
      EXPECT_NEAR(once.layout[i].ratio, again.layout[i].ratio, 1e-10);
      EXPECT_LT(once.layout[i].turn.angularDistance(again.layout[i].turn), 1e-6);
    }
  }
}

TEST(MeanValueEncoding, isNotThatOfAMirrorImage) {
  TriangleMesh mesh = tent(0.4);
  const double offset = encodeMeanValues(mesh).offset[6];
  mesh.vertices.col(0) *= -1;
  EXPECT_NEAR(encodeMeanValues(mesh).offset[6], -offset, 1e-12);
}

TEST(MeanValueEncoding, derivativesAreThoseOfDifferences) {
  for (const TriangleMesh& mesh : shapes()) {
    const MeanValueEncoding encoding = encodeMeanValues(mesh);
    const Points bent =
        mesh.vertices + 0.02 * test::randomPoints(static_cast<int>(mesh.vertices.rows()), 3);
    for (int v = 0; v < mesh.vertices.rows(); v += 3) {
      const Eigen::Vector3d place = bent.row(v);
      const std::vector<Eigen::Vector3d> corners = cornersOf(encoding, v, bent);
      const MeanValueResidual at = meanValueResidual(encoding, v, place, corners, true);
      const double radius = (corners[0] - corners[1]).norm();
      for (std::size_t k = 0; k < corners.size(); ++k)
        for (int axis = 0; axis < 3; ++axis) {
          const double step = 1e-6 * radius;
          auto more = corners, less = corners;
          more[k][axis] += step;
          less[k][axis] -= step;
          const Eigen::Vector3d difference =
              (meanValueResidual(encoding, v, place, more, false).value -
               meanValueResidual(encoding, v, place, less, false).value) /
              (2 * step);
          EXPECT_LT((difference - at.by_corner[k].col(axis)).norm(),
                    1e-6 * (1 + at.by_corner[k].norm()));
        }
    }
  }
}

TEST(MeanValueEncoding, isDecodedFromThreeVerticesOrMany) {
  for (const TriangleMesh& mesh : {bumpy(), withDent(test::bentStrip(10, 5, 2, 1, 2)), tent(0.4)}) {
    const MeanValueEncoding encoding = encodeMeanValues(mesh);
    const Points truth = moved(mesh.vertices, similarity());
    const int n = static_cast<int>(truth.rows());
    std::vector<int> few{0, n / 3, n - 2}, many;
    for (int v = 0; v < n; v += 2) many.push_back(v);
    for (const std::vector<int>& fixed : {few, many}) {
      const Points decoded = decodeMeanValues(encoding, fixed, rows(truth, fixed));
      EXPECT_LT(gap(decoded, truth), 1e-9);
      for (int v : fixed) EXPECT_EQ(decoded.row(v), truth.row(v));
    }
  }
}

TEST(MeanValueEncoding, isDecodedFromARoughStart) {
  const TriangleMesh mesh = bumpy();
  const MeanValueEncoding encoding = encodeMeanValues(mesh);
  const int n = static_cast<int>(mesh.vertices.rows());
  std::vector<int> fixed;
  for (int v = 0; v < n; v += 6) fixed.push_back(v);
  const Points start = mesh.vertices + 0.05 * test::randomPoints(n, 9);
  const Points decoded = decodeMeanValues(encoding, fixed, rows(mesh.vertices, fixed), start);
  EXPECT_LT(gap(decoded, mesh.vertices), 1e-9);
}

TEST(MeanValueEncoding, decodesEachPartByItself) {
  TriangleMesh mesh = twoParts();
  const MeanValueEncoding encoding = encodeMeanValues(mesh);
  const int n = static_cast<int>(mesh.vertices.rows()), m = n - 66;  // vertices of the first part
  mesh.vertices.bottomRows(66) = moved(mesh.vertices.bottomRows(66), similarity());
  const std::vector<int> fixed{0, 20, 40, m, m + 12, n - 1};
  EXPECT_LT(gap(decodeMeanValues(encoding, fixed, rows(mesh.vertices, fixed)), mesh.vertices),
            1e-9);
  const std::vector<int> first_only{0, 20, 40};
  EXPECT_THROW(decodeMeanValues(encoding, first_only, rows(mesh.vertices, first_only)),
               std::invalid_argument);
}

TEST(MeanValueEncoding, aFlatPartFollowsItsCornersInThePlane) {
  // Mean-value coordinates are kept by any affine map of the plane.
  const TriangleMesh mesh = test::grid(6, 4, 2, 1);
  Points sheared = mesh.vertices;
  sheared.col(0) += 0.5 * mesh.vertices.col(1);
  sheared.col(1) *= 1.5;
  const std::vector<int> fixed{0, 6, 34};
  EXPECT_LT(gap(decodeMeanValues(encodeMeanValues(mesh), fixed, rows(sheared, fixed)), sheared),
            1e-8);
}

TEST(MeanValueEncoding, refusesWhatDoesNotDetermineAShape) {
  const TriangleMesh mesh = test::grid(6, 4, 2, 1);
  const MeanValueEncoding encoding = encodeMeanValues(mesh);
  const auto decode = [&](const std::vector<int>& fixed) {
    return decodeMeanValues(encoding, fixed, rows(mesh.vertices, fixed));
  };
  EXPECT_NO_THROW(decode({0, 6, 34}));
  EXPECT_THROW(decode({0, 6}), std::invalid_argument);
  EXPECT_THROW(decode({0, 3, 6}), std::invalid_argument);  // in one line
  EXPECT_THROW(decode({0, 6, 6}), std::invalid_argument);
  EXPECT_THROW(decodeMeanValues(encoding, {0, 6, 99}, rows(mesh.vertices, {0, 6, 34})),
               std::invalid_argument);
  EXPECT_THROW(decodeMeanValues(encoding, {0, 6, 34}, rows(mesh.vertices, {0, 6})),
               std::invalid_argument);
  TriangleMesh line = mesh, loose = mesh;
  line.vertices.rightCols(2).setZero();
  EXPECT_THROW(encodeMeanValues(line), InputError);
  loose.vertices.conservativeResize(mesh.vertices.rows() + 1, 3);
  loose.vertices.bottomRows(1) << 1, 2, 3;
  EXPECT_THROW(encodeMeanValues(loose), std::invalid_argument);
}

TEST(MeanValueEncoding, hasALayoutOnlyWhereAskedFor) {
  for (const TriangleMesh& mesh : shapes()) {
    const MeanValueEncoding with = encodeMeanValues(mesh), without = encodeMeanValues(mesh, false);
    EXPECT_EQ(without.first, with.first);
    EXPECT_EQ(without.corner, with.corner);
    EXPECT_EQ(without.weight, with.weight);
    EXPECT_EQ(without.offset, with.offset);
    EXPECT_EQ(with.layout.size(), static_cast<std::size_t>(mesh.vertices.rows()));
    EXPECT_TRUE(without.layout.empty());
  }
  const TriangleMesh mesh = bumpy();
  const std::vector<int> fixed{0, 20, 40};
  EXPECT_THROW(decodeMeanValues(encodeMeanValues(mesh, false), fixed, rows(mesh.vertices, fixed)),
               std::invalid_argument);
}

TEST(MeanValueEncoding, refusesWhatIsTooSmallToHaveAnArea) {
  TriangleMesh mesh = test::sphere(1);
  mesh.vertices *= 1e-100;  // the square of an area vanishes
  EXPECT_THROW(encodeMeanValues(mesh), InputError);
}

class MeanValueEncodingOfBenchmark : public test::BenchmarkTest {};

TEST_F(MeanValueEncodingOfBenchmark, reproducesItsShapes) {
  for (const char* name :
       {"cat/cat-reference.obj", "gorilla/gorilla5.off", "captures/rabbit-scan.obj"}) {
    const TriangleMesh mesh = cleanMesh(readMesh(folder_ / "meshes" / name).mesh).mesh;
    const int n = static_cast<int>(mesh.vertices.rows());
    const std::vector<int> fixed{0, n / 3, n - 1};
    const Points decoded =
        decodeMeanValues(encodeMeanValues(mesh), fixed, rows(mesh.vertices, fixed));
    const double size =
        (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).norm();
    EXPECT_LT(gap(decoded, mesh.vertices), 1e-8 * size) << name;
  }
}

}  // namespace
}  // namespace posture
