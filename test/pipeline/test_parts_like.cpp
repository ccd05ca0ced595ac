// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/edge_paths.h>
#include <posture/mesh/edges.h>
#include <posture/pipeline/register_shapes.h>

#include <gtest/gtest.h>

#include "sides/given_shape.h"
#include "sides/parts_like.h"
#include "support/bodies.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace posture {
namespace {

using test::person;

/// What lies around a hand: `share` of the body's vertices, the others left out.
struct Piece {
  TriangleMesh mesh;
  std::map<int, int> of_body;  ///< vertex of the body -> vertex of the piece
};

Piece aroundAHand(const TriangleMesh& body, double share) {
  Eigen::Index hand = 0;
  body.vertices.col(0).maxCoeff(&hand);
  const Vector away = EdgePaths(body).lengths({static_cast<int>(hand)});
  Vector sorted = away;
  std::sort(sorted.begin(), sorted.end());
  const double reach = sorted[static_cast<Eigen::Index>(share * static_cast<double>(away.size()))];
  Piece piece;
  std::vector<int> kept;
  for (int v = 0; v < away.size(); ++v)
    if (away[v] <= reach) {
      piece.of_body[v] = static_cast<int>(kept.size());
      kept.push_back(v);
    }
  piece.mesh = {body.vertices(kept, Eigen::all), Faces(body.faces.rows(), 3)};
  Eigen::Index faces = 0;
  for (const auto& face : body.faces.rowwise())
    if (away(face).maxCoeff() <= reach) {
      for (int k = 0; k < 3; ++k) piece.mesh.faces(faces, k) = piece.of_body.at(face[k]);
      ++faces;
    }
  piece.mesh.faces.conservativeResize(faces, 3);
  return piece;
}

/// A piece of one pose and the whole of another, and where its vertices are on it.
struct PieceAndWhole {
  PieceAndWhole() {
    const ArticulatedBody body = person(0, 0), other = person(4, 1);
    piece = aroundAHand(body.mesh, 0.4);
    whole = other.mesh;
    for (const VertexPair& pair : groundTruth(body, other))
      if (const auto v = piece.of_body.find(pair.source); v != piece.of_body.end())
        truth.push_back({v->second, pair.target});
  }

  double size() const { return rootArea(whole); }

  Piece piece;
  TriangleMesh whole;
  std::vector<VertexPair> truth;
};

TEST(PartsLike, aSurfaceWithALongRimMayBeSome) {
  const PieceAndWhole shapes;
  EXPECT_TRUE(mayBePiece(cleanMesh(shapes.piece.mesh)));
  EXPECT_FALSE(mayBePiece(cleanMesh(shapes.whole)));
}

TEST(PartsLike, noLimbComesOutOfPinholes) {
  TriangleMesh pinholes = test::sphere(4);
  const auto n = pinholes.faces.rows();
  for (int k = 1; k <= 8; ++k) pinholes.faces.row(k * n / 9) = pinholes.faces.row(n - k);
  pinholes.faces.conservativeResize(n - 8, 3);
  double rims = 0;
  for (const Edge& e : meshEdges(pinholes.faces))
    if (e.faces == 1)
      rims += (pinholes.vertices.row(e.first) - pinholes.vertices.row(e.second)).norm();
  ASSERT_GT(rims, 0.4 * rootArea(pinholes));
  EXPECT_FALSE(mayBePiece(cleanMesh(pinholes)));
}

TEST(PartsLike, aSurfaceMayBeSomeWhereMoreThanCrumbsLieOffIt) {
  const auto withPieceOf = [](double radius) {
    TriangleMesh piece = test::sphere(3);
    piece.vertices = (radius * piece.vertices).rowwise() + Eigen::RowVector3d(2, 0, 0);
    return cleanMesh(withPieces(test::sphere(4), piece));
  };
  EXPECT_FALSE(mayBePiece(withPieceOf(0.1)));  // a hundredth of the area
  EXPECT_TRUE(mayBePiece(withPieceOf(0.2)));
}

TEST(PartsLike, oneOfThePartsHasAllThatThePieceHas) {
  const PieceAndWhole shapes;
  const CleanMesh whole = cleanMesh(shapes.whole);
  const auto parts = partsLike(cleanMesh(shapes.piece.mesh), {shapes.whole, whole}, 3);
  ASSERT_FALSE(parts.empty());
  double best = 0;
  for (const CleanMesh& part : parts) {
    EXPECT_LT(faceAreas(part.mesh).sum(), 0.9 * faceAreas(shapes.whole).sum());
    const auto inside =
        std::count_if(shapes.truth.begin(), shapes.truth.end(), [&](const VertexPair& pair) {
          return part.offset[pair.target] == 0;
        });
    const double share = static_cast<double>(inside) / static_cast<double>(shapes.truth.size());
    if (static_cast<double>(part.mesh.vertices.rows()) <
        0.7 * static_cast<double>(shapes.whole.vertices.rows()))
      best = std::max(best, share);
  }
  EXPECT_GT(best, 0.9);
}

TEST(PartsLike, partsTellWhichOfTheWholesFacesAreTheirsAndHowAllWereTurned) {
  PieceAndWhole shapes;
  for (int f = 0; f < shapes.whole.faces.rows(); f += 7)
    std::swap(shapes.whole.faces(f, 1), shapes.whole.faces(f, 2));
  const CleanMesh whole = cleanMesh(shapes.whole);
  const auto parts = partsLike(cleanMesh(shapes.piece.mesh), {shapes.whole, whole}, 3);
  ASSERT_FALSE(parts.empty());
  const Faces alike = facedAlike(shapes.whole.faces, whole);
  for (const CleanMesh& part : parts) {
    ASSERT_EQ(part.face_on_main.size(), shapes.whole.faces.rows());
    EXPECT_EQ(std::count(part.face_on_main.begin(), part.face_on_main.end(), 1),
              part.mesh.faces.rows());
    EXPECT_EQ(facedAlike(shapes.whole.faces, part), alike);
    for (int f = 0; f < alike.rows(); ++f) {
      if (part.face_on_main[f] == 0) continue;
      for (int k = 0; k < 3; ++k) EXPECT_EQ(part.offset[alike(f, k)], 0) << f;
    }
  }
}

TEST(PartsLike, aPieceIsFoundOnTheWhole) {
  const PieceAndWhole shapes;
  const RegistrationResult result = registerShapes(shapes.piece.mesh, shapes.whole);
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  EXPECT_EQ(result.source.compared_share, 1);
  EXPECT_LT(result.target.compared_share, 0.7);
  // Parts that are far from like it are not gone on with.
  std::set<std::string> bent, refined;
  for (const StageTiming& t : result.timings) {
    if (t.attempt.rfind("piece-", 0) != 0) continue;
    if (t.stage == "bending") bent.insert(t.attempt);
    if (t.stage == "refinement") refined.insert(t.attempt);
  }
  EXPECT_GT(bent.size(), 1);
  EXPECT_GE(refined.size(), 1);
  EXPECT_LT(refined.size(), bent.size());
  EXPECT_NEAR(result.target.area, faceAreas(shapes.whole).sum(), 1e-9);
  double sum = 0;
  int mapped = 0;
  for (const VertexPair& pair : shapes.truth) {
    const int found = result.correspondence.on_target[pair.source].vertex;
    if (found < 0) continue;
    ++mapped;
    sum += (shapes.whole.vertices.row(found) - shapes.whole.vertices.row(pair.target)).norm();
  }
  EXPECT_GT(mapped, 0.9 * static_cast<double>(shapes.truth.size()));
  EXPECT_LT(sum / mapped, 0.04 * shapes.size());
}

TEST(PartsLike, whatAPieceLacksHasNoCounterpartOnIt) {
  const PieceAndWhole shapes;
  const RegistrationResult result = registerShapes(shapes.whole, shapes.piece.mesh);
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  EXPECT_LT(result.source.compared_share, 0.7);
  std::map<int, int> place;
  for (const VertexPair& pair : shapes.truth) place[pair.target] = pair.source;
  double sum = 0;
  int mapped = 0, astray = 0;
  for (int v = 0; v < shapes.whole.vertices.rows(); ++v) {
    const int found = result.correspondence.on_target[v].vertex;
    if (found < 0) continue;
    ++mapped;
    const auto known = place.find(v);
    if (known == place.end()) continue;
    const double off =
        (shapes.piece.mesh.vertices.row(found) - shapes.piece.mesh.vertices.row(known->second))
            .norm();
    sum += off;
    astray += off > 0.2 * shapes.size();
  }
  // The truth names a vertex of the whole for each of the piece, not the other way round.
  EXPECT_LT(mapped, 0.55 * static_cast<double>(shapes.whole.vertices.rows()));
  EXPECT_GT(mapped, 0.3 * static_cast<double>(shapes.whole.vertices.rows()));
  EXPECT_EQ(astray, 0);
  EXPECT_LT(sum / static_cast<double>(place.size()), 0.04 * shapes.size());
  // The rest goes with it in one piece.
  const std::vector<Edge> edges = meshEdges(shapes.whole.faces);
  const auto isTorn = [&](const Edge& e) {
    const double length =
        (shapes.whole.vertices.row(e.first) - shapes.whole.vertices.row(e.second)).norm();
    const double ratio = (result.deformed.row(e.first) - result.deformed.row(e.second)).norm() /
                         (result.scale * length);
    return ratio > 2 || ratio < 0.5;
  };
  EXPECT_LT(std::count_if(edges.begin(), edges.end(), isTorn),
            0.01 * static_cast<double>(edges.size()));
}

}  // namespace
}  // namespace posture
