// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>
#include <posture/refine/bent_pair.h>
#include <posture/refine/carry_up.h>
#include <posture/refine/settle.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "refine/poses.h"
#include "support/motions.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

Points placesAt(const TriangleMesh& mesh, const std::vector<int>& vertices) {
  Points places(vertices.size(), 3);
  for (std::size_t i = 0; i < vertices.size(); ++i) places.row(i) = mesh.vertices.row(vertices[i]);
  return places;
}

/// Each vertex bent to where its match lies.
BentPair startFrom(const BendableSurface& a, const BendableSurface& b, const VertexMaps& maps) {
  return {maps, placesAt(b.mesh, maps.forward), placesAt(a.mesh, maps.backward)};
}

/// As soft as the pipeline's surfaces in the middle of their way.
double softnessOf(const SpectralSurface& surface) {
  return 0.3 * surface.eigenvalues[surface.eigenvalues.size() - 1];
}

Eigen::Isometry3d motion() {
  return Eigen::Translation3d(0.4, 0.5, -0.6) *
         Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 3).normalized());
}

double meanGap(const Points& x, const Points& y) { return (x - y).rowwise().norm().mean(); }

Eigen::RowVector3d placeOf(const FacePoint& point, const TriangleMesh& mesh) {
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 3; ++k)
    place += point.barycentric[k] * mesh.vertices.row(mesh.faces(point.face, k));
  return place;
}

/// The nearest vertices of two meshes that lie on each other, each bent to where it is.
BentPair inPlace(const TriangleMesh& a, const TriangleMesh& b) {
  BentPair pair;
  pair.bent_a = a.vertices;
  pair.bent_b = b.vertices;
  const PointIndex index_a(a.vertices), index_b(b.vertices);
  for (int v = 0; v < a.vertices.rows(); ++v)
    pair.maps.forward.push_back(index_b.nearest(a.vertices.row(v)).index);
  for (int v = 0; v < b.vertices.rows(); ++v)
    pair.maps.backward.push_back(index_a.nearest(b.vertices.row(v)).index);
  return pair;
}

void expectBarycentric(const std::vector<FacePoint>& places, const TriangleMesh& mesh) {
  for (const FacePoint& place : places) {
    ASSERT_GE(place.face, 0);
    ASSERT_LT(place.face, mesh.faces.rows());
    EXPECT_GE(place.barycentric.minCoeff(), 0);
    EXPECT_NEAR(place.barycentric.sum(), 1, 1e-12);
  }
}

TEST(Settle, aMapOffByOneVertexEverywhereComesBack) {
  for (BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED}) {
    const test::Poses& poses = test::poses(kind);
    const VertexMaps truth = test::identity(poses.a);
    BentPair pair = startFrom(poses.a, poses.b, test::perturbed(poses, 1, 1));
    for (std::size_t v = 0; v < truth.forward.size(); ++v)
      ASSERT_NE(pair.maps.forward[v], truth.forward[v]);
    settle(poses.a, poses.b, softnessOf(poses.b), 10, pair);
    int wrong = 0;
    for (std::size_t v = 0; v < truth.forward.size(); ++v)
      wrong +=
          (pair.maps.forward[v] != truth.forward[v]) + (pair.maps.backward[v] != truth.backward[v]);
    EXPECT_LE(wrong, 0.01 * 2 * static_cast<double>(truth.forward.size()));
    const double edge = meanEdgeLength(poses.b.mesh);
    EXPECT_LT(meanGap(pair.bent_a, poses.b.mesh.vertices), 0.15 * edge);
    EXPECT_LT(meanGap(pair.bent_b, poses.a.mesh.vertices), 0.15 * edge);
  }
}

TEST(Settle, verticesGoneAstrayFollowTheirNeighbours) {
  const test::Poses& poses = test::poses(BodyKind::QUADRUPED);
  const VertexMaps truth = test::identity(poses.a);
  VertexMaps start = truth;
  const int n = static_cast<int>(truth.forward.size());
  Rng rng(1);
  for (int i = 0; i < n / 20; ++i) {
    start.forward[rng.below(n)] = rng.below(n);
    start.backward[rng.below(n)] = rng.below(n);
  }
  BentPair pair = startFrom(poses.a, poses.b, start);
  settle(poses.a, poses.b, softnessOf(poses.b), 10, pair);
  const auto astray = [&](const TriangleMesh& mesh, const std::vector<int>& matches) {
    const Vector miss = (placesAt(mesh, matches) - mesh.vertices).rowwise().norm();
    return (miss.array() > 1.5 * meanEdgeLength(mesh)).count();
  };
  // Of one in twenty; where several lie together, the surface may have yielded to them.
  EXPECT_LE(astray(poses.b.mesh, pair.maps.forward) + astray(poses.a.mesh, pair.maps.backward),
            0.005 * 2 * n);
}

TEST(Settle, normalsTellTheTwoSidesOfAThinBody) {
  // Hardly thicker than a disc. A part is matched through to the other side, where all places are
  // nearly right.
  TriangleMesh disc = test::sphere(3);
  disc.vertices *= Eigen::Vector3d(0.4, 0.4, 0.004).asDiagonal();
  const BendableSurface surface(disc);
  std::vector<int> same(disc.vertices.rows()), through(disc.vertices.rows());
  for (int v = 0; v < disc.vertices.rows(); ++v) {
    same[v] = through[v] = v;
    const Eigen::RowVector3d opposite =
        disc.vertices.row(v).cwiseProduct(Eigen::RowVector3d(1, 1, -1));
    if (opposite.x() > 0.1)
      (disc.vertices.rowwise() - opposite).rowwise().norm().minCoeff(&through[v]);
  }
  BentPair pair = startFrom(surface, surface, {through, through});
  settle(surface, surface, 100, 10, pair);
  // Where the wrong part begins the surface folds, and a fold yields: a seam may stay.
  int wrong = 0, wrong_at_first = 0;
  for (std::size_t v = 0; v < same.size(); ++v) {
    wrong += pair.maps.forward[v] != same[v];
    wrong_at_first += through[v] != same[v];
  }
  EXPECT_LE(wrong, 0.1 * wrong_at_first);
}

TEST(Settle, leavesARigidMotionAsItIs) {
  const TriangleMesh mesh = test::bentStrip(20, 10, 2, 1, 2);
  const BendableSurface a(mesh), b(test::moved(mesh, motion()));
  std::vector<int> same(mesh.vertices.rows());
  for (std::size_t v = 0; v < same.size(); ++v) same[v] = static_cast<int>(v);
  BentPair pair = startFrom(a, b, {same, same});
  settle(a, b, 100, 3, pair);
  EXPECT_EQ(pair.maps.forward, same);
  EXPECT_EQ(pair.maps.backward, same);
  EXPECT_LT(meanGap(pair.bent_a, b.mesh.vertices), 1e-9);
  EXPECT_LT(meanGap(pair.bent_b, a.mesh.vertices), 1e-9);
  polish(a, b, 100, 3, pair);
  anneal(a, b, 100, pair);
  EXPECT_EQ(pair.maps.forward, same);
  EXPECT_EQ(pair.maps.backward, same);
  EXPECT_LT(meanGap(pair.bent_a, b.mesh.vertices), 1e-9);
  EXPECT_LT(meanGap(pair.bent_b, a.mesh.vertices), 1e-9);
}

TEST(Anneal, bringsPlacesHomeThatSettlingLeavesOnTheirWay) {
  for (BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED}) {
    const test::Poses& poses = test::poses(kind);
    const double softness = poses.b.eigenvalues[poses.b.eigenvalues.size() - 1];
    BentPair settled = startFrom(poses.a, poses.b, test::perturbed(poses, 1, 1));
    BentPair annealed = settled;
    for (double share : {0.1, 0.3, 1.0}) settle(poses.a, poses.b, share * softness, 6, settled);
    anneal(poses.a, poses.b, softness, annealed);
    EXPECT_LT(test::meanError(poses.b, annealed.maps.forward), 0.01);
    EXPECT_LT(meanGap(annealed.bent_a, poses.b.mesh.vertices),
              0.7 * meanGap(settled.bent_a, poses.b.mesh.vertices));
    EXPECT_LT(meanGap(annealed.bent_b, poses.a.mesh.vertices),
              0.7 * meanGap(settled.bent_b, poses.a.mesh.vertices));
  }
}

TEST(Polish, comesFartherThanSettlingInAsManyRounds) {
  for (BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED}) {
    const test::Poses& poses = test::poses(kind);
    const double softness = softnessOf(poses.b);
    BentPair settled = startFrom(poses.a, poses.b, test::perturbed(poses, 1, 1));
    settle(poses.a, poses.b, softness, 5, settled);
    BentPair polished = settled;
    settle(poses.a, poses.b, softness, 10, settled);
    polish(poses.a, poses.b, softness, 10, polished);
    EXPECT_LT(meanGap(polished.bent_a, poses.b.mesh.vertices),
              0.9 * meanGap(settled.bent_a, poses.b.mesh.vertices));
    EXPECT_LT(meanGap(polished.bent_b, poses.a.mesh.vertices),
              0.9 * meanGap(settled.bent_b, poses.a.mesh.vertices));
  }
}

TEST(Settle, doesNothingInNoRounds) {
  const BendableSurface sphere(test::sphere(1));
  std::vector<int> same(42, 7);
  BentPair pair = startFrom(sphere, sphere, {same, same});
  settle(sphere, sphere, 10, 0, pair);
  EXPECT_EQ(pair.maps.forward, same);
}

TEST(Settle, doesNotDrawASurfaceToTheRimOfAHole) {
  // One of two like sheets has a hole: what belongs in it has the rim for its match.
  const TriangleMesh whole = test::grid(24, 16, 1.5, 1);
  TriangleMesh pierced = whole;
  int count = 0;
  const Eigen::RowVector3d centre(0.75, 0.5, 0);
  for (int f = 0; f < whole.faces.rows(); ++f)
    if ((whole.vertices.row(whole.faces(f, 0)) - centre).norm() > 0.25)
      pierced.faces.row(count++) = whole.faces.row(f);
  pierced.faces.conservativeResize(count, 3);
  pierced = cleanMesh(pierced).mesh;
  const BendableSurface a(whole), b(pierced);
  // The rim is where they begin; or where they come to, from a map that stays off it.
  const BentPair at_rim = inPlace(whole, pierced);
  BentPair beside_rim = at_rim;
  for (int& v : beside_rim.maps.forward) {
    if (!b.on_boundary[v]) continue;
    const auto inner = std::find_if(
        b.neighbors.begin(v), b.neighbors.end(v), [&](int w) { return !b.on_boundary[w]; });
    if (inner != b.neighbors.end(v)) v = *inner;
  }
  const double near = 0.5 * meanEdgeLength(whole);
  const auto expectInPlace = [&](const BentPair& pair) {
    int in_hole = 0;
    for (int v = 0; v < whole.vertices.rows(); ++v) {
      if ((whole.vertices.row(v) - centre).norm() > 0.15) continue;
      ++in_hole;
      EXPECT_LT((pair.bent_a.row(v) - whole.vertices.row(v)).norm(), near);
    }
    EXPECT_GT(in_hole, 10);
  };
  for (BentPair pair : {at_rim, beside_rim}) {
    pair.bent_a = placesAt(pierced, pair.maps.forward);
    BentPair annealed = pair;
    settle(a, b, 200, 10, pair);
    expectInPlace(pair);
    anneal(a, b, 200, annealed);
    expectInPlace(annealed);
  }
}

TEST(CarryUp, ofARigidMotionIsThatMotion) {
  const TriangleMesh a = test::spectralSurface(test::bentStrip(40, 20, 2, 1, 2), 3).mesh;
  const TriangleMesh b = test::moved(a, motion());
  const ReducedMesh reduced_a = reduceMesh(a, 200);
  ReducedMesh reduced_b = reduced_a;
  reduced_b.mesh.vertices = test::moved(reduced_a.mesh.vertices, motion());
  const BendableSurface work_a(reduced_a.mesh), work_b(reduced_b.mesh);
  std::vector<int> same(reduced_a.vertex.size());
  for (std::size_t v = 0; v < same.size(); ++v) same[v] = static_cast<int>(v);
  const BentPair full =
      carryUp(a, reduced_a, b, reduced_b, startFrom(work_a, work_b, {same, same}));
  ASSERT_EQ(full.maps.forward.size(), static_cast<std::size_t>(a.vertices.rows()));
  ASSERT_EQ(full.maps.backward.size(), static_cast<std::size_t>(b.vertices.rows()));
  // The identity at the vertices kept, and nowhere far from it.
  for (int v : reduced_a.vertex) {
    EXPECT_EQ(full.maps.forward[v], v);
    EXPECT_EQ(full.maps.backward[v], v);
  }
  for (int v = 0; v < a.vertices.rows(); ++v)
    EXPECT_EQ(full.maps.forward[v], reduced_a.vertex[reduced_a.nearest[v]]);
  // All the others go along, turned with the surface around them.
  EXPECT_LT((full.bent_a - b.vertices).rowwise().norm().maxCoeff(), 1e-9);
  EXPECT_LT((full.bent_b - a.vertices).rowwise().norm().maxCoeff(), 1e-9);
}

TEST(CarryUp, followsABend) {
  const TriangleMesh a = test::grid(40, 20, 2, 1), b = test::bentStrip(40, 20, 2, 1, 1.5);
  const ReducedMesh reduced_a = reduceMesh(a, 300), reduced_b = reduceMesh(b, 250);
  const BendableSurface work_a(reduced_a.mesh), work_b(reduced_b.mesh);
  BentPair pair;  // the numbering of vertices is the same on the full meshes
  for (int v : reduced_a.vertex) pair.maps.forward.push_back(reduced_b.nearest[v]);
  for (int v : reduced_b.vertex) pair.maps.backward.push_back(reduced_a.nearest[v]);
  pair.bent_a = placesAt(b, reduced_a.vertex);
  pair.bent_b = placesAt(a, reduced_b.vertex);
  const BentPair full = carryUp(a, reduced_a, b, reduced_b, pair);
  const double edge = meanEdgeLength(a), spacing = 2 * std::sqrt(2.0 / 250);
  EXPECT_LT(meanGap(full.bent_a, b.vertices), 0.1 * edge);
  EXPECT_LT(meanGap(full.bent_b, a.vertices), 0.1 * edge);
  for (std::size_t i = 0; i < reduced_a.vertex.size(); ++i)
    EXPECT_LT((full.bent_a.row(reduced_a.vertex[i]) - pair.bent_a.row(i)).norm(), 1e-6);
  for (int v = 0; v < a.vertices.rows(); ++v)
    EXPECT_LT((b.vertices.row(full.maps.forward[v]) - b.vertices.row(v)).norm(), 2 * spacing);
}

TEST(PlacesOnFaces, ofTheIdentityAreTheVertices) {
  const test::Poses& poses = test::poses(BodyKind::QUADRUPED);
  const BentPair pair = startFrom(poses.a, poses.b, test::identity(poses.a));
  const auto places = placesOnFaces(poses.a, poses.b, softnessOf(poses.b), pair);
  ASSERT_EQ(places.size(), pair.maps.forward.size());
  expectBarycentric(places, poses.b.mesh);
  for (std::size_t v = 0; v < places.size(); ++v)
    for (int k = 0; k < 3; ++k)
      if (poses.b.mesh.faces(places[v].face, k) == static_cast<int>(v)) {
        EXPECT_NEAR(places[v].barycentric[k], 1, 1e-6);
      } else {
        EXPECT_NEAR(places[v].barycentric[k], 0, 1e-6);
      }
}

TEST(PlacesOnFaces, areInTheFacesAroundTheMatch) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const BentPair pair = startFrom(poses.a, poses.b, test::perturbed(poses, 2, 1));
  const auto places = placesOnFaces(poses.a, poses.b, softnessOf(poses.b), pair);
  expectBarycentric(places, poses.b.mesh);
  for (std::size_t v = 0; v < places.size(); ++v)
    EXPECT_TRUE((poses.b.mesh.faces.row(places[v].face).array() == pair.maps.forward[v]).any());
}

TEST(PlacesOnFaces, areExactInAPlane) {
  // A fine sheet on a coarse one: every place is known. Those beyond its edge go to the edge.
  TriangleMesh fine = test::grid(37, 23, 1.4, 1), coarse = test::grid(12, 9, 1.3, 1);
  fine.vertices.col(0).array() -= 0.05;
  const BendableSurface a(fine), b(coarse);
  const auto places = placesOnFaces(a, b, 100, inPlace(fine, coarse));
  expectBarycentric(places, coarse);
  for (int v = 0; v < fine.vertices.rows(); ++v) {
    Eigen::RowVector3d expected = fine.vertices.row(v);
    expected.x() = std::min(std::max(expected.x(), 0.0), 1.3);
    EXPECT_LT((placeOf(places[v], coarse) - expected).norm(), 1e-6);
  }
}

TEST(PlacesOnFaces, areFiniteOnFacesWithoutArea) {
  TriangleMesh fine = test::grid(20, 20, 1, 1), coarse = test::grid(6, 6, 1, 1);
  // All on one line, and all at one place: every vertex of the first rows is in a flat face.
  for (int v = 0; v < 14; ++v) coarse.vertices(v, 1) = 0;
  for (int v = 14; v < 18; ++v) coarse.vertices.row(v) = coarse.vertices.row(14);
  const BendableSurface a(fine), b(coarse);
  expectBarycentric(placesOnFaces(a, b, 100, inPlace(fine, coarse)), coarse);
}

}  // namespace
}  // namespace posture
