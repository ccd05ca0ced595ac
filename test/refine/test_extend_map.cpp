// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/refine/extend_map.h>

#include <gtest/gtest.h>

#include "refine/club.h"
#include "refine/poses.h"
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// The true map where `is_known`, the rest apart.
template <class IsKnown>
BentPair knownWhere(const SpectralSurface& a, const SpectralSurface& b, const IsKnown& is_known) {
  BentPair pair{test::identity(a), b.mesh.vertices, a.mesh.vertices};
  for (int v = 0; v < a.mesh.vertices.rows(); ++v) pair.apart_a.push_back(!is_known(v));
  pair.apart_b = pair.apart_a;
  for (int v = 0; v < a.mesh.vertices.rows(); ++v)
    if (pair.apart_a[v] != 0) {  // nowhere in particular
      pair.maps.forward[v] = pair.maps.backward[v] = 0;
      pair.bent_a.row(v) = b.mesh.vertices.row(0);
      pair.bent_b.row(v) = a.mesh.vertices.row(0);
    }
  return pair;
}

/// In edges, of what is not apart.
double meanMiss(const SpectralSurface& b, const BentPair& pair) {
  double sum = 0;
  int count = 0;
  for (int v = 0; v < static_cast<int>(pair.maps.forward.size()); ++v) {
    if (isApart(pair.apart_a, v)) continue;
    sum += (b.mesh.vertices.row(pair.maps.forward[v]) - b.mesh.vertices.row(v)).norm();
    ++count;
  }
  return sum / (count * meanEdgeLength(b.mesh));
}

double softnessOf(const SpectralSurface& surface) {
  return surface.eigenvalues[surface.eigenvalues.size() - 1];
}

TEST(ExtendMap, limbsThatBendAreFollowedFromTheTrunk) {
  const test::Poses& poses = test::poses(BodyKind::HUMAN);
  const Points& rest = poses.body_a.rest_position;
  const double reach = rest.col(0).maxCoeff();  // left and right of the plane of symmetry
  const BentPair known =
      knownWhere(poses.a, poses.b, [&](int v) { return std::abs(rest(v, 0)) < 0.4 * reach; });
  ASSERT_GT(areaShare(poses.a, known.apart_a), 0.1);
  const BentPair whole = extendMap(poses.a, poses.b, softnessOf(poses.a), known).pair;
  EXPECT_LT(areaShare(poses.a, whole.apart_a), 0.02);
  EXPECT_LT(areaShare(poses.b, whole.apart_b), 0.02);
  EXPECT_LT(meanMiss(poses.b, whole), 1);
}

TEST(ExtendMap, whatTheOtherSurfaceLacksStaysApart) {
  constexpr double CUT = 0.3;
  const SpectralSurface whole = test::spectralSurface(test::clubWithHand(), 100);
  const test::CutClub club(whole.mesh, CUT);
  const SpectralSurface cut(
      club.mesh, whole.functions(club.of_whole, Eigen::all).cast<double>(), whole.eigenvalues);
  // Known is the half of the body that is away from the arm.
  const double middle = whole.mesh.vertices.col(0).mean();
  BentPair pair{{std::vector<int>(whole.mesh.vertices.rows(), 0), club.of_whole},
                whole.mesh.vertices,
                cut.mesh.vertices,
                std::vector<char>(whole.mesh.vertices.rows(), 1),
                std::vector<char>(club.of_whole.size(), 1)};
  for (std::size_t i = 0; i < club.of_whole.size(); ++i) {
    const int v = club.of_whole[i];
    pair.maps.forward[v] = static_cast<int>(i);
    if (whole.mesh.vertices(v, 0) < middle) pair.apart_a[v] = pair.apart_b[i] = 0;
  }
  const BentPair extended = extendMap(whole, cut, softnessOf(whole), pair).pair;
  EXPECT_LT(areaShare(cut, extended.apart_b), 0.02);
  const double tip = whole.mesh.vertices.col(0).maxCoeff();
  int of_hand = 0, apart = 0;
  for (int v = 0; v < whole.mesh.vertices.rows(); ++v)
    if (whole.mesh.vertices(v, 0) > tip - 0.7 * CUT) {
      ++of_hand;
      apart += extended.apart_a[v];
      // It goes as the arm does.
      EXPECT_LT((extended.bent_a.row(v) - whole.mesh.vertices.row(v)).norm(), 0.05);
    }
  EXPECT_GT(apart, 0.9 * of_hand);
}

}  // namespace
}  // namespace posture
