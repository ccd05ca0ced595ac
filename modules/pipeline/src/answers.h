// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "finalists.h"
#include <cstddef>
#include <vector>

namespace posture {

/// Mean distance on the target between where two maps take the source's vertices, straight: no
/// unit, as the body's area is about one.
double gapBetween(const TriangleMesh& target, const VertexMaps& x, const VertexMaps& y);

/// Of finalists by increasing score, the first and those that differ from every better one by more
/// than `gap`: different answers.
std::vector<int> distinctFinalists(const std::vector<Finalist>& finalists,
                                   const TriangleMesh& target,
                                   double gap);

/// The first `most` of different finalists, but always with the one that a finalist goes with.
std::vector<int> foremost(const std::vector<int>& distinct,
                          const std::vector<Finalist>& finalists,
                          const TriangleMesh& target,
                          int finalist,
                          std::size_t most);

/// Those worth refining: the first two, the best of other answers where their scores are too near
/// to decide - of several where none convinces - and one that was laid if there is any.
std::vector<int> leadingOf(const std::vector<Finalist>& finalists,
                           const std::vector<int>& distinct);

/// Where refinement led different answers.
class RefinedAnswers {
 public:
  /// \param refined  by increasing score. All are referred to.
  /// \param coarse_target, target  the meshes that finalists and refined maps lead to.
  /// \param gap  how far apart two places are not the same any more.
  RefinedAnswers(const std::vector<RefinedMap>& refined,
                 const std::vector<Finalist>& finalists,
                 const TriangleMesh& coarse_target,
                 const TriangleMesh& target,
                 double gap);

  /// The best refined map that began as an answer; null: none did.
  const RefinedMap* of(int finalist) const;

  /// Whether a finalist that was another answer was led to the best one.
  bool becameBest(int finalist) const;

 private:
  const std::vector<RefinedMap>& refined_;
  const std::vector<Finalist>& finalists_;
  const TriangleMesh& coarse_target_;
  const TriangleMesh& target_;
  double gap_;
};

}  // namespace posture
