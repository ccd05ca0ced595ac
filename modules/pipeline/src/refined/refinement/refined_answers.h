// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/finalists/finalists.h"
#include "refined/refinement/refined_maps.h"
#include <vector>

namespace posture {

/// Where refinement led different answers.
class RefinedAnswers {
 public:
  /// \param refined  the best first, at least one. Referred to.
  /// \param distinct  of `finalists`.
  /// \param coarse_target, target  the meshes that finalists and refined maps lead to.
  /// \param gap  how far apart two places are not the same any more.
  RefinedAnswers(const std::vector<RefinedMap>& refined,
                 const std::vector<Finalist>& finalists,
                 const std::vector<int>& distinct,
                 const TriangleMesh& coarse_target,
                 const TriangleMesh& target,
                 double gap);

  /// The answer of the best map: of those that refinement led there alone, or that it began as, the
  /// one that scored best before.
  int chosen() const { return chosen_; }

  /// The different answers without the others that refinement led to the best map alone.
  const std::vector<int>& remaining() const { return remaining_; }

  /// The best refined map that an answer became; null: it was not refined. Only maps that differ
  /// from the best one, but for the chosen answer.
  const RefinedMap* of(int answer) const;

 private:
  /// Whether every map refined from an answer is like the best one, and there is one.
  bool leadsToBest(int answer) const;

  const std::vector<RefinedMap>& refined_;
  int chosen_ = 0;
  std::vector<int> remaining_;
  std::vector<int> began_as_;    // an answer for each refined map
  std::vector<char> like_best_;  // each refined map
};

}  // namespace posture
