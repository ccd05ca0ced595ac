// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answers.h"

#include "verdict.h"
#include <algorithm>
#include <iterator>
#include <limits>

namespace posture {

std::vector<int> distinctFinalists(const std::vector<Finalist>& finalists,
                                   const TriangleMesh& target,
                                   double gap) {
  std::vector<int> distinct;
  for (int i = 0; i < static_cast<int>(finalists.size()); ++i)
    if (std::none_of(distinct.begin(), distinct.end(), [&](int k) {
          return gapBetween(target, finalists[i].maps, finalists[k].maps) <= gap;
        }))
      distinct.push_back(i);
  return distinct;
}

bool isAllButCertain(const std::vector<Finalist>& finalists, const std::vector<int>& distinct) {
  const auto score = [&](std::size_t k) { return finalists[distinct[k]].score.total(); };
  const double margin =
      distinct.size() > 1 ? score(1) - score(0) : std::numeric_limits<double>::infinity();
  return trustIn(score(0), margin) >= ALL_BUT_CERTAIN;
}

std::vector<int> foremost(const std::vector<int>& answers, int chosen, std::size_t most) {
  std::vector<int> first(
      answers.begin(),
      answers.begin() + static_cast<std::ptrdiff_t>(std::min(most, answers.size())));
  if (std::find(first.begin(), first.end(), chosen) == first.end()) first.back() = chosen;
  return first;
}

std::vector<int> leadingOf(const std::vector<Finalist>& finalists,
                           const std::vector<int>& distinct) {
  constexpr std::size_t ANSWERS = 4;
  const double best = finalists.front().score.total();
  std::vector<int> leading;
  for (std::size_t k = 0; k < std::min(ANSWERS, distinct.size()); ++k)
    if (!isDecisive(best, finalists[distinct[k]].score.total())) leading.push_back(distinct[k]);
  const auto first_laid =
      std::find_if(finalists.begin(), finalists.end(), [](const Finalist& f) { return f.laid; });
  const int laid = static_cast<int>(first_laid - finalists.begin());
  if (first_laid != finalists.end() &&
      std::find(leading.begin(), leading.end(), laid) == leading.end())
    leading.push_back(laid);
  return leading;
}

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
    like_best_.push_back(gapBetween(target, map.pair.maps, refined.front().pair.maps) <= gap);
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
