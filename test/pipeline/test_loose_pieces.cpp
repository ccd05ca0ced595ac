// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/compact_vertices.h>
#include <posture/mesh/clean_mesh.h>

#include <gtest/gtest.h>

#include "pipeline/limb_in_two.h"
#include "refined/completion/loose_pieces.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

using LoosePieces = test::LimbInTwo;

TEST_F(LoosePieces, thePieceFindsItsOwnVertices) {
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

TEST_F(LoosePieces, aPieceThatFitsNowhereHasNoCounterpart) {
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

TEST_F(LoosePieces, verticesThatTheTargetKeptOfWhatWasCutAwayAreNoPlace) {
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

}  // namespace
}  // namespace posture
