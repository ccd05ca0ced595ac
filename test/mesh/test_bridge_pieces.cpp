// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/bridge_pieces.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/edges.h>

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

TriangleMesh joined(TriangleMesh mesh, const Bridges& bridges) {
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
  const TriangleMesh mesh = joined(apart, bridges);
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
  const TriangleMesh mesh = joined(apart, bridges);
  expectSound(mesh);
  // Nearly all of the band is closed again.
  EXPECT_GT(faceAreas(mesh).sum() - faceAreas(apart).sum(),
            0.8 * (faceAreas(test::sphere(4)).sum() - faceAreas(apart).sum()));
}

TEST(BridgePieces, havePiecesWithoutARimAlone) {
  const TriangleMesh ball = test::sphere(2), sheet = test::grid(40, 40, 4, 4);
  TriangleMesh mesh;
  mesh.vertices.resize(ball.vertices.rows() + sheet.vertices.rows(), 3);
  mesh.vertices << (0.2 * ball.vertices).rowwise() + Eigen::RowVector3d(-0.25, 2, 0),
      sheet.vertices;
  mesh.faces.resize(ball.faces.rows() + sheet.faces.rows(), 3);
  mesh.faces << ball.faces, sheet.faces.array() + static_cast<int>(ball.vertices.rows());
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
