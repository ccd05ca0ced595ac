// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/mesh/areas.h>
#include <posture/refine/map_score.h>
#include <posture/spectral/spectral_basis.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "refine/poses.h"
#include "support/shapes.h"
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace posture {
namespace {

VertexMaps shuffled(const SpectralSurface& surface, std::uint64_t seed) {
  VertexMaps maps = test::identity(surface);
  Rng rng(seed);
  const int n = static_cast<int>(maps.forward.size());
  for (int i = n - 1; i > 0; --i) std::swap(maps.forward[i], maps.forward[rng.below(i + 1)]);
  for (int v = 0; v < n; ++v) maps.backward[maps.forward[v]] = v;
  return maps;
}

TriangleMesh turned(TriangleMesh mesh) {
  const Eigen::AngleAxisd turn(2.1, Eigen::Vector3d(1, -2, 3).normalized());
  mesh.vertices =
      (mesh.vertices * turn.toRotationMatrix().transpose()).rowwise() + Eigen::RowVector3d(4, 5, 6);
  return mesh;
}

/// Seen in a mirror, with its outside out.
TriangleMesh reflected(TriangleMesh mesh) {
  mesh.vertices.col(0) *= -1;
  mesh.faces.col(0).swap(mesh.faces.col(1));
  return mesh;
}

/// A body without any symmetry.
TriangleMesh lump() {
  TriangleMesh mesh = test::sphere(3);
  mesh.vertices *= Eigen::Vector3d(1, 1.3, 1.8).asDiagonal();
  mesh.vertices.col(0) += 0.15 * mesh.vertices.col(2).cwiseAbs2();
  mesh.vertices.col(1) += 0.2 * mesh.vertices.col(0).cwiseProduct(mesh.vertices.col(2));
  return mesh;
}

TEST(MapScore, totalCountsEveryTermByItsRatio) {
  const MapScore score{0.1, 0.2, 0.3, 0.4};
  for (double MapScore::*term : {&MapScore::bending, &MapScore::curvature, &MapScore::distortion}) {
    MapScore worse = score;
    worse.*term *= 2;
    EXPECT_NEAR(worse.total() - score.total(), std::log(2), 1e-12);
  }
  MapScore worse = score;
  worse.return_miss *= 2;
  EXPECT_NEAR(worse.total() - score.total(), std::log(2), 0.03);
}

TEST(MapScore, ofNothingAgainstAMapIsFinite) {
  EXPECT_TRUE(std::isfinite(MapScore{}.total()));
  // Nor does one term of next to nothing decide.
  EXPECT_EQ((MapScore{1e-30, 1, 1, 1}).total(), (MapScore{1e-20, 1, 1, 1}).total());
}

TEST(ScoreMaps, aRigidMotionHasNothingAgainstIt) {
  const SpectralSurface a = test::spectralSurface(lump(), 60),
                        b = test::spectralSurface(turned(lump()), 60);
  const MapScore score = scoreMaps(a, b, test::identity(a));
  EXPECT_LT(score.bending, 1e-4);
  EXPECT_LT(score.curvature, 1e-4);
  EXPECT_LT(score.distortion, 1e-6);
  EXPECT_EQ(score.return_miss, 0);
  for (double term : {score.bending, score.curvature, score.distortion}) EXPECT_GE(term, -1e-6);
}

TEST(ScoreMaps, isTheSameBothWays) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const VertexMaps maps = test::perturbed(poses, 2, 1);
  const MapScore there = scoreMaps(poses.a, poses.b, maps),
                 back = scoreMaps(poses.b, poses.a, {maps.backward, maps.forward});
  EXPECT_NEAR(there.bending, back.bending, 1e-4 * there.bending);
  EXPECT_NEAR(there.curvature, back.curvature, 1e-4 * there.curvature);
  EXPECT_NEAR(there.distortion, back.distortion, 1e-9);
  EXPECT_NEAR(there.return_miss, back.return_miss, 1e-9);
}

/// A lump and the half of it above y = 0, in one unit.
struct WholeAndHalf {
  WholeAndHalf() {
    const TriangleMesh mesh = lump();
    number.assign(mesh.vertices.rows(), -1);
    TriangleMesh upper = mesh;
    int kept = 0;
    for (int f = 0; f < mesh.faces.rows(); ++f)
      if (mesh.vertices(mesh.faces(f, 0), 1) > 0) upper.faces.row(kept++) = mesh.faces.row(f);
    upper.faces.conservativeResize(kept, 3);
    for (int& v : upper.faces.reshaped()) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(of_half.size());
        of_half.push_back(v);
      }
      v = number[v];
    }
    upper.vertices = mesh.vertices(of_half, Eigen::all);
    whole = surface(mesh);
    half = surface(upper);
  }

  /// The vertex of the half nearest to a place.
  int nearest(const Eigen::RowVector3d& place) const {
    Eigen::Index found = 0;
    (half->mesh.vertices.rowwise() - place).rowwise().norm().minCoeff(&found);
    return static_cast<int>(found);
  }

  static std::unique_ptr<SpectralSurface> surface(TriangleMesh mesh) {
    mesh.vertices /= rootArea(lump());
    const SpectralBasis basis = spectralBasis(cotangentLaplacian(mesh), 60);
    return std::make_unique<SpectralSurface>(mesh, basis.functions, basis.eigenvalues);
  }

  std::unique_ptr<SpectralSurface> whole, half;
  std::vector<int> number;   ///< vertex of the whole -> of the half; -1: none
  std::vector<int> of_half;  ///< and back
};

TEST(ScoreMaps, doesNotHoldAgainstAMapWhatTheTargetLacks) {
  // Half a body against the whole one: the right map is right on the half there is.
  const WholeAndHalf shapes;
  const SpectralSurface &a = *shapes.whole, &b = *shapes.half;
  VertexMaps maps;
  maps.backward = shapes.of_half;
  for (int v = 0; v < a.mesh.vertices.rows(); ++v)
    maps.forward.push_back(shapes.number[v] >= 0 ? shapes.number[v]
                                                 : shapes.nearest(a.mesh.vertices.row(v)));
  const MapScore score = scoreMaps(a, b, maps);
  EXPECT_LT(score.bending, 0.05);
  EXPECT_LT(score.distortion, 0.05);
  EXPECT_LT(score.return_miss, 0.01);
  // The same half, taken for the other one.
  VertexMaps wrong = maps;
  for (int& v : wrong.backward) {
    Eigen::Index opposite = 0;
    (a.mesh.vertices.rowwise() + a.mesh.vertices.row(v)).rowwise().norm().minCoeff(&opposite);
    v = static_cast<int>(opposite);
  }
  EXPECT_LT(score.total(), scoreMaps(a, b, wrong).total() - 2);
}

TEST(ScoreBent, doesNotHoldAgainstAMapWhatLiesOnTheInside) {
  // The whole laid on its upper half, the lower half of it folded up against the inside.
  const WholeAndHalf shapes;
  const SpectralSurface &a = *shapes.whole, &b = *shapes.half;
  BentPair laid{{{}, shapes.of_half}, a.mesh.vertices, b.mesh.vertices};
  for (int v = 0; v < a.mesh.vertices.rows(); ++v) {
    Eigen::RowVector3d folded = a.mesh.vertices.row(v);
    folded[1] = std::abs(folded[1]);
    const int number = shapes.number[v];
    laid.maps.forward.push_back(number >= 0 ? number : shapes.nearest(folded));
    if (number < 0) laid.bent_a.row(v) = b.mesh.vertices.row(laid.maps.forward.back());
  }
  const MapScore fair = scoreBent(a, b, laid, true), blind = scoreMaps(a, b, laid.maps);
  EXPECT_LT(fair.total(), blind.total() - 2);
  EXPECT_LT(fair.distortion, 0.05);
  EXPECT_LT(fair.return_miss, 0.05);
  // Where all have a counterpart, there is no difference.
  const BentPair there{test::identity(a), a.mesh.vertices, a.mesh.vertices};
  EXPECT_EQ(scoreBent(a, a, there, true).total(), scoreMaps(a, a, there.maps).total());
}

TEST(ScoreMaps, theTruthIsBetterThanWhatIsWrong) {
  for (BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED}) {
    const test::Poses& poses = test::poses(kind);
    const MapScore truth = scoreMaps(poses.a, poses.b, test::identity(poses.a));
    const MapScore mirror = scoreMaps(poses.a, poses.b, test::mirrored(poses));
    const MapScore noise = scoreMaps(poses.a, poses.b, test::perturbed(poses, 3, 2));
    const MapScore shuffle = scoreMaps(poses.a, poses.b, shuffled(poses.a, 3));
    EXPECT_LT(truth.total(), mirror.total() - 2);
    EXPECT_LT(mirror.total(), noise.total() - 2);
    EXPECT_LT(noise.total(), shuffle.total() - 2);
    // Every term by itself knows noise from the truth; and turning a body inside out bends it.
    EXPECT_LT(2 * truth.bending, mirror.bending);
    EXPECT_LT(2 * truth.bending, noise.bending);
    EXPECT_LT(2 * truth.curvature, noise.curvature);
    EXPECT_LT(2 * truth.distortion, noise.distortion);
    EXPECT_LT(truth.return_miss + 0.1, noise.return_miss);
    // What nothing is left of counts as about one.
    EXPECT_NEAR(shuffle.curvature, 1, 0.2);
  }
}

TEST(ScoreMaps, bendingHasTheStrainOfABentBody) {
  // Stretching by 10 % along one axis: the strain of that, whatever the map's other virtues.
  const SpectralSurface a = test::spectralSurface(lump(), 60);
  TriangleMesh longer = a.mesh;
  longer.vertices.col(2) *= 1.1;
  const SpectralBasis basis = spectralBasis(cotangentLaplacian(longer), 60);
  const SpectralSurface b(longer, basis.functions, basis.eigenvalues);
  const auto strainOf = [](const SpectralSurface& from, const Points& bent) {
    return from.arap.energy(bent);
  };
  const double expected = 0.5 * (strainOf(a, b.mesh.vertices) + strainOf(b, a.mesh.vertices));
  const double found = scoreMaps(a, b, test::identity(a)).bending;
  // Surfaces give way a little rather than go all the way.
  EXPECT_LT(found, 1.05 * expected);
  EXPECT_GT(found, 0.5 * expected);
}

TEST(Orientation, isOneForRigidMotionsAndMinusOneForReflections) {
  const TriangleMesh mesh = lump();
  const SpectralSurface a = test::spectralSurface(mesh, 5);
  const VertexMaps same = test::identity(a);
  EXPECT_DOUBLE_EQ(orientation(a, a, same), 1);
  EXPECT_DOUBLE_EQ(orientation(a, test::spectralSurface(turned(mesh), 5), same), 1);
  EXPECT_DOUBLE_EQ(orientation(a, test::spectralSurface(reflected(mesh), 5), same), -1);
}

TEST(Orientation, ofTheAntipodesIsMinusOne) {
  const SpectralSurface sphere = test::spectralSurface(test::sphere(3), 5);
  VertexMaps maps = test::identity(sphere);
  for (int& v : maps.forward)
    (sphere.mesh.vertices.rowwise() + sphere.mesh.vertices.row(v)).rowwise().norm().minCoeff(&v);
  maps.backward = maps.forward;
  EXPECT_DOUBLE_EQ(orientation(sphere, sphere, maps), -1);
}

TEST(Orientation, countsBothDirections) {
  const TriangleMesh mesh = lump();
  const SpectralSurface a = test::spectralSurface(mesh, 5),
                        b = test::spectralSurface(reflected(mesh), 5);
  VertexMaps maps = test::identity(a);
  for (int& v : maps.backward) v = 0;  // all to one place: no face has a side
  EXPECT_DOUBLE_EQ(orientation(a, b, maps), -0.5);
  for (int& v : maps.forward) v = 0;
  EXPECT_DOUBLE_EQ(orientation(a, b, maps), 0);
}

TEST(Orientation, tellsLeftFromRightBetweenPoses) {
  for (BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED}) {
    const test::Poses& poses = test::poses(kind);
    EXPECT_GT(orientation(poses.a, poses.b, test::identity(poses.a)), 0.99);
    EXPECT_LT(orientation(poses.a, poses.b, test::mirrored(poses)), -0.98);
    EXPECT_NEAR(orientation(poses.a, poses.b, shuffled(poses.a, 1)), 0, 0.1);
  }
}

TEST(MapScore, lettingGoIsNoGainByItself) {
  MapScore all{0.05, 0.1, 0.07, 0.03};
  MapScore half = all;
  half.let_go = 0.5;
  EXPECT_NEAR(half.total() - all.total(), 4 * std::log(2), 1e-12);
}

TEST(MapScore, aPieceDoesNotPayForWhatTheWholeHasMore) {
  MapScore piece{0.05, 0.1, 0.07, 0.03};
  const double all = piece.total();
  piece.let_go = 0.7;
  piece.bending /= 1 - piece.let_go;  // as it is measured
  EXPECT_NEAR(piece.totalOfPiece(), all, 1e-12);
  piece.least_let_go = 0.7;
  EXPECT_NEAR(piece.totalOfPiece(), piece.total(), 1e-12);
}

}  // namespace
}  // namespace posture
