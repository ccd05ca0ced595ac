// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finalists/distinct_finalists.h"

#include "answer/verdict.h"
#include "refined/finalists/answer_gap.h"
#include <algorithm>
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

bool anyConvincesWhole(const std::vector<Finalist>& finalists) {
  return std::any_of(finalists.begin(), finalists.end(), [](const Finalist& finalist) {
    return finalist.score.let_go == 0 && convinces(finalist.score.total());
  });
}

bool isAllButCertain(const std::vector<Finalist>& finalists, const std::vector<int>& distinct) {
  const auto score = [&](std::size_t k) { return finalists[distinct[k]].score.total(); };
  const double margin =
      distinct.size() > 1 ? score(1) - score(0) : std::numeric_limits<double>::infinity();
  return trustIn(score(0), margin) >= ALL_BUT_CERTAIN;
}

std::vector<int> foremost(const std::vector<int>& answers,
                          const std::vector<int>& kept,
                          std::size_t most) {
  std::size_t room = most - std::min(most, kept.size());
  std::vector<int> first;
  for (int answer : answers) {
    const bool is_kept = std::find(kept.begin(), kept.end(), answer) != kept.end();
    if (is_kept || room > 0) first.push_back(answer);
    if (!is_kept && room > 0) --room;
  }
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

}  // namespace posture
