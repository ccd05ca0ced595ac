// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/bridge_pieces.h>
#include <posture/mesh/connected_parts.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace posture {
namespace {

using test::joined;
using test::shifted;

/// Without the faces whose middle `drop` wants away.
template <class Drop>
TriangleMesh without(TriangleMesh mesh, const Drop& drop) {
  int kept = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d middle =
        mesh.vertices(mesh.faces.row(f).transpose(), Eigen::all).colwise().mean();
    if (!drop(middle)) mesh.faces.row(kept++) = mesh.faces.row(f).eval();
  }
  mesh.faces.conservativeResize(kept, 3);
  return mesh;
}

TriangleMesh bridged(TriangleMesh mesh, const Bridges& bridges) {
  mesh.faces.conservativeResize(mesh.faces.rows() + bridges.faces.rows(), 3);
  mesh.faces.bottomRows(bridges.faces.rows()) = bridges.faces;
  return mesh;
}

/// Every half-edge once: no edge with three faces, none between faces that look two ways.
void expectSound(const TriangleMesh& mesh) {
  std::set<std::pair<int, int>> half_edges;
  for (const auto& f : mesh.faces.rowwise())
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(half_edges.emplace(f[k], f[(k + 1) % 3]).second) << f[k] << " " << f[(k + 1) % 3];
}

/// A sheet of 2 x 1 in squares of 0.05, divided across at x = 0.5 and 1.5.
TriangleMesh threePieces() {
  return without(test::grid(40, 20, 2, 1), [](const auto& middle) {
    return (middle[0] > 0.5 && middle[0] < 0.55) || (middle[0] > 1.5 && middle[0] < 1.55);
  });
}

TEST(BridgePieces, joinPiecesAcrossNarrowGaps) {
  const TriangleMesh apart = threePieces();
  ASSERT_EQ(connectedParts(apart).area.size(), 3u);
  const Bridges bridges = bridgePieces(apart);
  EXPECT_EQ(bridges.pieces, 2);
  const TriangleMesh mesh = bridged(apart, bridges);
  EXPECT_EQ(connectedParts(mesh).area.size(), 1u);
  expectSound(mesh);
  // All along the gap, and flat as the sheet is.
  EXPECT_NEAR(faceAreas(mesh).sum(), 2, 0.02);
  for (const auto& f : bridges.faces.rowwise()) {
    const Eigen::RowVector3d a = mesh.vertices.row(f[0]);
    const Eigen::Vector3d normal =
        (mesh.vertices.row(f[1]) - a).cross(mesh.vertices.row(f[2]) - a).transpose();
    EXPECT_GT(normal[2], 0);
  }
}

TEST(BridgePieces, leaveWideGapsOpen) {
  // 0.1 wide, where a twentieth of the square root of the area is 0.07.
  const TriangleMesh apart = without(test::grid(40, 20, 2, 1), [](const auto& middle) {
    return middle[0] > 0.5 && middle[0] < 0.6;
  });
  const Bridges bridges = bridgePieces(apart);
  EXPECT_EQ(bridges.pieces, 0);
  EXPECT_EQ(bridges.faces.rows(), 0);
}

TEST(BridgePieces, joinTheHalvesOfASphere) {
  const TriangleMesh apart =
      without(test::sphere(4), [](const auto& middle) { return std::abs(middle[2] - 0.2) < 0.06; });
  ASSERT_EQ(connectedParts(apart).area.size(), 2u);
  const Bridges bridges = bridgePieces(apart);
  EXPECT_EQ(bridges.pieces, 1);
  const TriangleMesh mesh = bridged(apart, bridges);
  expectSound(mesh);
  // Nearly all of the band is closed again.
  EXPECT_GT(faceAreas(mesh).sum() - faceAreas(apart).sum(),
            0.8 * (faceAreas(test::sphere(4)).sum() - faceAreas(apart).sum()));
}

/// A sheet, another right above it, which no face may go on to, and a strip near that one alone.
TriangleMesh layers() {
  const TriangleMesh sheet = test::grid(40, 40, 4, 4), strip = test::grid(40, 10, 4, 1);
  return joined(joined(sheet, shifted(sheet, {0, 0, 0.2})), shifted(strip, {0, -1.1, 0.3}));
}

TEST(BridgePieces, countOnlyWhatIsJoinedToTheLargest) {
  const Bridges bridges = bridgePieces(layers());
  EXPECT_EQ(bridges.pieces, 0);
  EXPECT_EQ(bridges.faces.rows(), 0);
}

TEST(BridgePieces, joinByWayOfAnotherWhatCannotBeJoinedItself) {
  // A strip between the two sheets that goes on beyond the rim of either.
  const TriangleMesh mesh = joined(layers(), shifted(test::grid(40, 10, 4, 1), {0, -1.05, 0.1}));
  const Bridges bridges = bridgePieces(mesh);
  EXPECT_EQ(bridges.pieces, 3);
  EXPECT_EQ(connectedParts(bridged(mesh, bridges)).area.size(), 1u);
  expectSound(bridged(mesh, bridges));
}

TEST(BridgePieces, joinThousandsOfPieces) {
  constexpr int SIDE = 50;
  const TriangleMesh apart =
      without(test::grid(6 * SIDE, 6 * SIDE, SIDE, SIDE), [](const auto& middle) {
        return std::max(middle[0] - std::floor(middle[0]), middle[1] - std::floor(middle[1])) >
               5.0 / 6;
      });
  const Bridges bridges = bridgePieces(apart);
  EXPECT_EQ(bridges.pieces, SIDE * SIDE - 1);
  EXPECT_EQ(connectedParts(bridged(apart, bridges)).area.size(), 1u);
  expectSound(bridged(apart, bridges));
}

TEST(BridgePieces, leaveEdgesWithManyFacesAlone) {
  // Two faces more at each edge of one side, which then is no rim.
  TriangleMesh apart = threePieces();
  std::set<std::pair<int, int>> half_edges;
  for (const auto& f : apart.faces.rowwise())
    for (int k = 0; k < 3; ++k) half_edges.emplace(f[k], f[(k + 1) % 3]);
  std::vector<std::array<int, 2>> side;
  for (const auto& [a, b] : half_edges)
    if (half_edges.count({b, a}) == 0 && std::abs(apart.vertices(a, 0) - 0.5) < 0.01 &&
        std::abs(apart.vertices(b, 0) - 0.5) < 0.01)
      side.push_back({a, b});
  ASSERT_EQ(side.size(), 20u);
  for (const auto& [a, b] : side) {
    const auto n = apart.vertices.rows(), m = apart.faces.rows();
    apart.vertices.conservativeResize(n + 1, 3);
    apart.vertices.row(n) = apart.vertices.row(a) + Eigen::RowVector3d(0, 0, 1);
    apart.faces.conservativeResize(m + 1, 3);
    apart.faces.row(m) << a, b, static_cast<int>(n);
  }
  std::set<std::pair<int, int>> busy;
  for (const auto& [a, b] : side) busy.emplace(b, a);
  const Bridges bridges = bridgePieces(apart);
  for (const auto& f : bridges.faces.rowwise())
    for (int k = 0; k < 3; ++k) EXPECT_EQ(busy.count({f[k], f[(k + 1) % 3]}), 0u);
}

TEST(BridgePieces, havePiecesWithoutARimAlone) {
  const TriangleMesh ball = test::sphere(2), sheet = test::grid(40, 40, 4, 4);
  const TriangleMesh mesh =
      joined(shifted({0.2 * ball.vertices, ball.faces}, {-0.25, 2, 0}), sheet);
  EXPECT_EQ(bridgePieces(mesh).pieces, 0);
  EXPECT_EQ(bridgePieces(ball).pieces, 0);
}

TEST(BridgePieces, doNotDependOnTheOrderOfVerticesAndFaces) {
  const TriangleMesh mesh = threePieces();
  const int n = static_cast<int>(mesh.vertices.rows()), m = static_cast<int>(mesh.faces.rows());
  // 7 and 11 divide neither: each number once.
  TriangleMesh shuffled = mesh;
  std::vector<int> number(n);
  for (int v = 0; v < n; ++v) {
    number[v] = (11 * v + 5) % n;
    shuffled.vertices.row(number[v]) = mesh.vertices.row(v);
  }
  for (int f = 0; f < m; ++f)
    for (int k = 0; k < 3; ++k)
      shuffled.faces((7 * f + 3) % m, k) = number[mesh.faces(f, (k + f) % 3)];
  const auto cornersOf = [](const Bridges& bridges, const auto& name) {
    std::set<std::array<int, 3>> faces;
    for (const auto& f : bridges.faces.rowwise()) {
      std::array<int, 3> corners{name(f[0]), name(f[1]), name(f[2])};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      faces.insert(corners);
    }
    return faces;
  };
  EXPECT_EQ(cornersOf(bridgePieces(mesh), [&](int v) { return number[v]; }),
            cornersOf(bridgePieces(shuffled), [](int v) { return v; }));
}

}  // namespace
}  // namespace posture
