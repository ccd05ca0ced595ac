// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/spectral/spectral_basis.h>

#include <gtest/gtest.h>

#include "refine/club.h"
#include "refined/finalists/finalists.h"
#include <vector>

namespace posture {
namespace {

constexpr double PI = 3.14159265358979323846;

/// A body with a hand at either end, mapped to itself with hands wound about their arms.
class ExchangeParts : public testing::Test {
 protected:
  /// \param end  1 or -1: which of the hands.
  static Points wound(const TriangleMesh& mesh, int end, double angle) {
    TriangleMesh facing = mesh;
    facing.vertices.col(0) *= end;
    facing.vertices = test::wound(facing, angle);
    facing.vertices.col(0) *= end;
    return facing.vertices;
  }

  static Finalist finalist(VertexMaps maps) {
    Finalist found;
    found.orientation = 1;
    found.score = scoreMaps(body(), body(), maps);
    found.maps = std::move(maps);
    return found;
  }

  static Finalist woundAt(int end) {
    return finalist({test::nearestOf(wound(mesh(), end, PI), mesh()),
                     test::nearestOf(wound(mesh(), end, -PI), mesh())});
  }

  static const SpectralSurface& body() {
    static const SpectralSurface surface = [] {
      TriangleMesh mesh = test::bodyWithTwoHands(0.8, 4);
      SpectralBasis basis = spectralBasis(cotangentLaplacian(mesh), FINALIST_BASIS);
      return SpectralSurface(std::move(mesh), basis.functions, std::move(basis.eigenvalues));
    }();
    return surface;
  }
  static const TriangleMesh& mesh() { return body().mesh; }

  /// Mean over the hand at an end, in edges.
  static double missAt(int end, const VertexMaps& maps) { return missOf(end, maps.forward); }
  static double missBackAt(int end, const VertexMaps& maps) { return missOf(end, maps.backward); }
  static double missOf(int end, const std::vector<int>& map) {
    TriangleMesh facing = mesh();
    facing.vertices.col(0) *= end;
    return test::meanMiss(facing, map);
  }

  static double gap() { return 2 * meanEdgeLength(mesh()); }
};

TEST_F(ExchangeParts, theBestTakesTheHandThatAnotherHasRight) {
  const Finalist best = woundAt(1), other = woundAt(-1);
  ASSERT_GT(missAt(1, best.maps), 1);
  ASSERT_GT(missBackAt(1, best.maps), 1);
  ASSERT_LT(missAt(-1, best.maps), 0.1);
  std::vector<Finalist> finalists{best, other};
  exchangeParts(body(), body(), gap(), finalists);
  ASSERT_EQ(finalists.size(), 3U);
  EXPECT_LT(missAt(1, finalists[0].maps), 0.2);
  EXPECT_LT(missAt(-1, finalists[0].maps), 0.2);
  EXPECT_LT(missBackAt(1, finalists[0].maps), 0.2);
  EXPECT_LT(missBackAt(-1, finalists[0].maps), 0.2);
  EXPECT_LT(finalists[0].score.total(), best.score.total() - 0.1);
  EXPECT_EQ(finalists[1].maps.forward, best.maps.forward) << "what it was made of stays";
  EXPECT_EQ(finalists[2].maps.forward, other.maps.forward);
}

TEST_F(ExchangeParts, theMixtureKeepsNothingThatWasOfTheOtherMap) {
  Finalist best = woundAt(1);
  best.bent = BentPair{best.maps, mesh().vertices, mesh().vertices};
  best.laid = true;
  best.scale = 1.1;
  best.orientation = 0.7;
  std::vector<Finalist> finalists{best, woundAt(-1)};
  exchangeParts(body(), body(), gap(), finalists);
  ASSERT_EQ(finalists.size(), 3U);
  EXPECT_FALSE(finalists[0].bent);
  EXPECT_FALSE(finalists[0].laid);
  EXPECT_EQ(finalists[0].scale, 1);
  EXPECT_EQ(finalists[0].orientation, 0.7);
  EXPECT_TRUE(finalists[1].bent) << "what it was made of stays";
  EXPECT_TRUE(finalists[1].laid);
}

TEST_F(ExchangeParts, nothingIsTakenThatMakesItWorse) {
  const Finalist right = finalist(
      {test::nearestOf(mesh().vertices, mesh()), test::nearestOf(mesh().vertices, mesh())});
  std::vector<Finalist> finalists{right, woundAt(1)};
  exchangeParts(body(), body(), gap(), finalists);
  ASSERT_EQ(finalists.size(), 2U);
  EXPECT_EQ(finalists[0].maps.forward, right.maps.forward);
}

TEST_F(ExchangeParts, nothingComesOfOneAlone) {
  const Finalist best = woundAt(1);
  std::vector<Finalist> finalists{best};
  exchangeParts(body(), body(), gap(), finalists);
  ASSERT_EQ(finalists.size(), 1U);
  EXPECT_EQ(finalists[0].maps.forward, best.maps.forward);
  finalists.clear();
  exchangeParts(body(), body(), gap(), finalists);
  EXPECT_TRUE(finalists.empty());
}

}  // namespace
}  // namespace posture
