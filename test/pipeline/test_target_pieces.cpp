// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/clean_mesh.h>

#include <gtest/gtest.h>

#include "pipeline/limb_in_two.h"
#include "refined/completion/loose_pieces.h"
#include "refined/completion/target_pieces.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

using TargetPieces = test::LimbInTwo;

TEST_F(TargetPieces, whatLiesOnAPieceOfTheTargetGetsItsPlaceThere) {
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
