// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/compact_vertices.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/rigid_motion.h>

#include <gtest/gtest.h>

#include "refined/completion/loose_pieces.h"
#include "refined/completion/target_pieces.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

constexpr double TRUST = 0.8, SCALE = 2;

/// A crooked limb, one unit long, with two knobs on its end: that fits in one way only.
TriangleMesh limb() {
  TriangleMesh mesh = test::sphere(4);
  for (auto p : mesh.vertices.rowwise()) {
    const auto knob = [&](const Eigen::RowVector3d& at, double height, double width) {
      return height * std::exp(-(p - at).squaredNorm() / (width * width));
    };
    const double along = 0.5 * (p.z() + 1),
                 knobs = 1 + knob({0.8, 0, 0.6}, 1.2, 0.3) + knob({-0.3, 0.75, 0.59}, 0.8, 0.2);
    p = Eigen::RowVector3d(0.12 * knobs * p.x() + 0.25 * along * along,
                           0.12 * knobs * p.y() + 0.1 * std::sin(4 * along),
                           along);
  }
  return mesh;
}

/// A limb, and the same without a band, so that its end is a piece: all vertices keep their
/// numbers.
class LimbInTwo : public testing::Test {
 protected:
  static constexpr double FROM = 0.6, TO = 0.66;

  LimbInTwo() {
    for (int f = 0; f < whole_.faces.rows(); ++f) {
      const auto face = whole_.faces.row(f);
      const auto isIn = [&](int v) { return inBand(v); };
      if (std::any_of(face.begin(), face.end(), isIn))
        cut_.faces.row(f).setConstant(face[0]);  // no face
    }
    cut_clean_ = cleanMesh(cut_);
  }

  bool inBand(int v) const { return whole_.vertices(v, 2) > FROM && whole_.vertices(v, 2) < TO; }
  bool isBeyond(int v) const { return whole_.vertices(v, 2) >= TO; }

  /// Farther from the gap than that.
  bool isWellInside(int v) const { return whole_.vertices(v, 2) > TO + 3 * edge_; }

  /// One side laid onto the other exactly, as far as its main surface goes; the rest stays behind.
  LaidSide laid(const Eigen::Isometry3d& motion, double scale) const {
    const auto n = whole_.vertices.rows();
    LaidSide side{scale,
                  TRUST,
                  {std::vector<SurfacePoint>(n), Vector::Zero(n)},
                  moved(motion, scale * whole_.vertices)};
    for (int v = 0; v < n; ++v)
      if (whole_.vertices(v, 2) <= FROM) {
        side.correspondence.on_target[v].vertex = v;
        side.correspondence.confidence[v] = TRUST;
      } else {
        side.deformed.row(v).setZero();
      }
    return side;
  }

  TriangleMesh movedWhole() const {
    return {moved(motion_, SCALE * whole_.vertices), whole_.faces};
  }

  const TriangleMesh whole_ = limb();
  const CleanMesh whole_clean_ = cleanMesh(whole_);
  TriangleMesh cut_ = whole_;
  CleanMesh cut_clean_;
  const double edge_ = meanEdgeLength(whole_);
  const Eigen::Isometry3d motion_ =
      Eigen::Translation3d(5, -2, 1) * Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized());
};

TEST_F(LimbInTwo, thePieceFindsItsOwnVertices) {
  ASSERT_FALSE(hasLoosePieces({whole_, whole_clean_}));
  const GivenShape source{cut_, cut_clean_};
  ASSERT_TRUE(hasLoosePieces(source));
  const TriangleMesh target = movedWhole();
  const CleanMesh target_clean = cleanMesh(target);
  LaidSide side = laid(motion_, SCALE);
  const std::vector<PlacedPiece> pieces = placeLoosePieces(source, {target, target_clean}, side);
  ASSERT_EQ(pieces.size(), 1);
  EXPECT_LT((pieces[0].motion.matrix() - motion_.matrix()).norm(), 1e-3);
  int beyond = 0;
  for (int v = 0; v < whole_.vertices.rows(); ++v) {
    if (!isBeyond(v)) continue;
    ++beyond;
    EXPECT_EQ(side.correspondence.on_target[v].vertex, v);
    EXPECT_NEAR(side.correspondence.confidence[v], TRUST, 0.01);
    EXPECT_LT((side.deformed.row(v) - target.vertices.row(v)).norm(), 1e-3);
  }
  EXPECT_EQ(pieces[0].vertices.size(), static_cast<std::size_t>(beyond));
}

TEST_F(LimbInTwo, aPieceThatFitsNowhereHasNoCounterpart) {
  // The target ends where the source's main surface does.
  std::vector<int> below;
  for (int f = 0; f < whole_.faces.rows(); ++f) {
    const auto face = whole_.faces.row(f);
    if (std::all_of(face.begin(), face.end(), [&](int v) { return whole_.vertices(v, 2) <= FROM; }))
      below.push_back(f);
  }
  TriangleMesh target{{}, whole_.faces(below, Eigen::all)};
  const std::vector<int> kept =
      compactVertices(target.faces, static_cast<int>(whole_.vertices.rows()));
  target.vertices = movedWhole().vertices(kept, Eigen::all);
  const CleanMesh target_clean = cleanMesh(target);
  LaidSide side = laid(motion_, SCALE);
  for (std::size_t i = 0; i < kept.size(); ++i)
    side.correspondence.on_target[kept[i]].vertex = static_cast<int>(i);
  for (int v = 0; v < whole_.vertices.rows(); ++v)
    if (isBeyond(v)) side.correspondence.on_target[v].vertex = 0;  // from what was next to it
  EXPECT_TRUE(placeLoosePieces({cut_, cut_clean_}, {target, target_clean}, side).empty());
  for (int v = 0; v < whole_.vertices.rows(); ++v)
    if (isWellInside(v)) {
      EXPECT_LT(side.correspondence.on_target[v].vertex, 0);
      EXPECT_LT((side.deformed.row(v) - movedWhole().vertices.row(v)).norm(), 0.05);
    }
}

TEST_F(LimbInTwo, verticesThatTheTargetKeptOfWhatWasCutAwayAreNoPlace) {
  TriangleMesh target = movedWhole();
  int kept = 0;
  for (int f = 0; f < whole_.faces.rows(); ++f) {
    const Eigen::RowVector3i face = whole_.faces.row(f);
    if (std::all_of(face.begin(), face.end(), [&](int v) { return whole_.vertices(v, 2) <= FROM; }))
      target.faces.row(kept++) = face;
  }
  target.faces.conservativeResize(kept, 3);
  const CleanMesh target_clean = cleanMesh(target);
  EXPECT_FALSE(hasLoosePieces({target, target_clean}));
  LaidSide side = laid(motion_, SCALE);
  EXPECT_TRUE(placeLoosePieces({cut_, cut_clean_}, {target, target_clean}, side).empty());
  for (int v = 0; v < whole_.vertices.rows(); ++v)
    if (isWellInside(v)) {
      EXPECT_LT(side.correspondence.on_target[v].vertex, 0) << v;
    }
}

TEST_F(LimbInTwo, whatLiesOnAPieceOfTheTargetGetsItsPlaceThere) {
  const TriangleMesh source = movedWhole();
  const CleanMesh source_clean = cleanMesh(source);
  const GivenShape from{source, source_clean}, to{cut_, cut_clean_};
  LaidSide back = laid(motion_, SCALE);  // the target on the source
  const std::vector<PlacedPiece> placed = placeLoosePieces(to, from, back);
  ASSERT_EQ(placed.size(), 1);
  const OnPieces found = onPieces(from, to, back, placed);
  EXPECT_FALSE(found.in_gap.empty());
  LaidSide there = laid(motion_.inverse(), 1 / SCALE);
  for (int v : found.in_gap) {
    there.correspondence.on_target[v].vertex = v;
    there.correspondence.confidence[v] = TRUST;
  }
  addMatches(from, found, there);
  for (std::size_t i = 0; i < found.vertex.size(); ++i) {
    const int v = found.vertex[i];
    EXPECT_LT((found.places.row(static_cast<Eigen::Index>(i)) - whole_.vertices.row(v)).norm(),
              1e-3);
    if (!isBeyond(v)) continue;
    EXPECT_EQ(there.correspondence.on_target[v].vertex, v);
    EXPECT_NEAR(there.correspondence.confidence[v], TRUST, 0.01);
  }
  for (int v = 0; v < whole_.vertices.rows(); ++v) {
    const bool is_found =
        std::find(found.vertex.begin(), found.vertex.end(), v) != found.vertex.end();
    EXPECT_TRUE(is_found || !isWellInside(v)) << v;
    EXPECT_FALSE(is_found && whole_.vertices(v, 2) < FROM - 3 * edge_) << v;
  }
  for (int v : found.in_gap) {
    EXPECT_FALSE(isWellInside(v));
    EXPECT_LT(there.correspondence.on_target[v].vertex, 0);
    EXPECT_EQ(there.correspondence.confidence[v], 0);
  }
}

}  // namespace
}  // namespace posture
