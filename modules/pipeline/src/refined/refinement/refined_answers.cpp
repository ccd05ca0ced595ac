// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refinement/refined_answers.h"

#include "refined/finalists/answer_gap.h"
#include <algorithm>
#include <cstddef>
#include <iterator>

namespace posture {

RefinedAnswers::RefinedAnswers(const std::vector<RefinedMap>& refined,
                               const std::vector<Finalist>& finalists,
                               const std::vector<int>& distinct,
                               const TriangleMesh& coarse_target,
                               const TriangleMesh& target,
                               double gap)
    : refined_(refined) {
  for (const RefinedMap& map : refined) {
    const auto far = [&](int answer) {
      return gapBetween(coarse_target, finalists[map.finalist].maps, finalists[answer].maps);
    };
    began_as_.push_back(*std::min_element(
        distinct.begin(), distinct.end(), [&](int i, int j) { return far(i) < far(j); }));
    like_best_.push_back(gapBetween(target, map.pair, refined.front().pair) <= gap);
  }
  chosen_ = *std::find_if(distinct.begin(), distinct.end(), [&](int answer) {
    return answer == began_as_.front() || leadsToBest(answer);
  });
  std::remove_copy_if(
      distinct.begin(), distinct.end(), std::back_inserter(remaining_), [&](int answer) {
        return answer != chosen_ && leadsToBest(answer);
      });
}

bool RefinedAnswers::leadsToBest(int answer) const {
  bool any = false;
  for (std::size_t i = 0; i < refined_.size(); ++i) {
    if (began_as_[i] != answer) continue;
    if (!like_best_[i]) return false;
    any = true;
  }
  return any;
}

const RefinedMap* RefinedAnswers::of(int answer) const {
  if (answer == chosen_) return &refined_.front();
  for (std::size_t i = 0; i < refined_.size(); ++i)
    if (began_as_[i] == answer && !like_best_[i]) return &refined_[i];
  return nullptr;
}

}  // namespace posture
