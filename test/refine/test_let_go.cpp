// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/refine/let_go.h>
#include <posture/refine/partners.h>
#include <posture/refine/settle.h>

#include <gtest/gtest.h>

#include "refine/club.h"
#include "refine/poses.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

/// A club and the same one cut off behind the hand. The first vertices of both are spread evenly,
/// as those of the sphere they are made of.
class LetGo : public testing::Test {
 protected:
  static constexpr double CUT = 0.3;  ///< from the tip; of an arm of about 0.9

  /// Those nearer to the tip than `reach`.
  static std::vector<char> end(const TriangleMesh& mesh, double reach) {
    const double tip = mesh.vertices.col(0).maxCoeff();
    std::vector<char> marked;
    for (const auto& p : mesh.vertices.rowwise()) marked.push_back(p.x() > tip - reach);
    return marked;
  }

  /// The whole arm squeezed onto what is left of it.
  BentPair squeezed() const {
    const test::SqueezedArm arm(whole_.mesh, CUT);
    Points onto = arm.squeezed(whole_.mesh.vertices), back = arm.drawnOut(cut_.mesh.vertices);
    return {{test::nearestOf(onto, cut_.mesh), test::nearestOf(back, whole_.mesh)}, onto, back};
  }

  /// In edges, of the vertices of the whole that are on the cut one and not marked.
  double meanMiss(const std::vector<int>& map, const std::vector<char>& leave_out) const {
    double sum = 0;
    int count = 0;
    for (int v : club_.of_whole) {
      if (leave_out[v]) continue;
      sum += (whole_.mesh.vertices.row(v) - cut_.mesh.vertices.row(map[v])).norm();
      ++count;
    }
    return sum / (count * meanEdgeLength(cut_.mesh));
  }

  static double share(const std::vector<char>& marked, const std::vector<char>& among) {
    int both = 0, all = 0;
    for (std::size_t v = 0; v < marked.size(); ++v) {
      all += among[v] != 0;
      both += among[v] != 0 && marked[v] != 0;
    }
    return static_cast<double>(both) / all;
  }
  static std::vector<char> inverse(std::vector<char> marked) {
    for (char& m : marked) m = m == 0;
    return marked;
  }

  const SpectralSurface whole_ = test::spectralSurface(test::clubWithHand(), 100);
  const test::CutClub club_{whole_.mesh, CUT};
  const SpectralSurface cut_{
      club_.mesh, whole_.functions(club_.of_whole, Eigen::all).cast<double>(), whole_.eigenvalues};
  const double softness_ = whole_.eigenvalues[whole_.eigenvalues.size() - 1];
};

TEST_F(LetGo, posesOfOneBodyMisplaceNothing) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const VertexMaps maps = test::identity(poses.a);
  const std::vector<char> marked = misplaced(poses.a, poses.b, maps.forward, {});
  EXPECT_EQ(areaShare(poses.a, marked), 0);
}

TEST_F(LetGo, anArmSqueezedOntoAStumpIsMisplaced) {
  const std::vector<char> marked = misplaced(whole_, cut_, squeezed().maps.forward, {});
  EXPECT_GT(share(marked, end(whole_.mesh, CUT / 2)), 0.7);
  EXPECT_LT(share(marked, inverse(end(whole_.mesh, 3 * CUT))), 0.01);
}

TEST_F(LetGo, whatTheOtherSurfaceLacksIsApartAndTheRestInItsPlace) {
  BentPair pair = squeezed();
  settle(whole_, cut_, softness_, 6, pair);
  const double before = meanMiss(pair.maps.forward, std::vector<char>(whole_.mesh.vertices.rows()));
  const MapScore squeezed_score = scoreMaps(whole_, cut_, pair.maps);
  const std::optional<MapScore> score = letGo(whole_, cut_, softness_, SCORE_NOISE, pair);
  ASSERT_TRUE(score);
  EXPECT_LT(score->total(), squeezed_score.total());
  EXPECT_GT(score->let_go, 0);
  // Not all of it: what is no more squeezed than bodies stretch may stay.
  EXPECT_GT(share(pair.apart_a, end(whole_.mesh, 0.7 * CUT)), 0.6);
  EXPECT_LT(share(pair.apart_a, inverse(end(whole_.mesh, CUT))), 0.05);
  EXPECT_LT(meanMiss(pair.maps.forward, pair.apart_a), 0.5 * before);
  EXPECT_LT(meanMiss(pair.maps.forward, pair.apart_a), 0.5);

  const std::vector<char> without = withoutPartner(whole_, cut_, pair, {});
  EXPECT_GT(share(without, end(whole_.mesh, 0.7 * CUT)), 0.9);
  // It goes as the arm does.
  double off = 0;
  for (int v = 0; v < whole_.mesh.vertices.rows(); ++v)
    if (pair.apart_a[v] != 0)
      off = std::max(off, (pair.bent_a.row(v) - whole_.mesh.vertices.row(v)).norm());
  EXPECT_LT(off, 0.05);
}

TEST_F(LetGo, whatFitsStaysAsItIs) {
  const VertexMaps maps = test::identity(whole_);
  BentPair pair{maps, whole_.mesh.vertices, whole_.mesh.vertices};
  EXPECT_FALSE(letGo(whole_, whole_, softness_, SCORE_NOISE, pair));
  EXPECT_EQ(pair.maps.forward, maps.forward);
  EXPECT_TRUE(pair.apart_a.empty());
}

}  // namespace
}  // namespace posture
