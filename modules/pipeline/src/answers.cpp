// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answers.h"

#include "verdict.h"
#include <algorithm>

namespace posture {

double gapBetween(const TriangleMesh& target, const VertexMaps& x, const VertexMaps& y) {
  double sum = 0;
  for (std::size_t v = 0; v < x.forward.size(); ++v)
    sum += (target.vertices.row(x.forward[v]) - target.vertices.row(y.forward[v])).norm();
  return sum / static_cast<double>(x.forward.size());
}

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

std::vector<int> foremost(const std::vector<int>& distinct,
                          const std::vector<Finalist>& finalists,
                          const TriangleMesh& target,
                          int finalist,
                          std::size_t most) {
  const auto gap = [&](int i) {
    return gapBetween(target, finalists[finalist].maps, finalists[i].maps);
  };
  const auto own = std::min_element(
      distinct.begin(), distinct.end(), [&](int i, int j) { return gap(i) < gap(j); });
  std::vector<int> first(
      distinct.begin(),
      distinct.begin() + static_cast<std::ptrdiff_t>(std::min(most, distinct.size())));
  if (own - distinct.begin() >= static_cast<std::ptrdiff_t>(first.size())) first.back() = *own;
  return first;
}

std::vector<int> leadingOf(const std::vector<Finalist>& finalists,
                           const std::vector<int>& distinct) {
  constexpr std::size_t LEADING = 2, ANSWERS = 4;
  // Refinement changes the difference between two answers by up to so much.
  constexpr double DECISIVE = 1;
  const double best = finalists.front().score.total();
  std::vector<int> leading;
  const auto add = [&](int i) {
    if (std::find(leading.begin(), leading.end(), i) == leading.end()) leading.push_back(i);
  };
  for (std::size_t i = 0; i < std::min(LEADING, finalists.size()); ++i) add(static_cast<int>(i));
  const std::size_t answers = std::min(distinct.size(), convinces(best) ? 2 : ANSWERS);
  for (std::size_t k = 1; k < answers; ++k)
    if (finalists[distinct[k]].score.total() < best + DECISIVE) add(distinct[k]);
  const auto laid = std::find_if(
      finalists.begin(), finalists.end(), [](const Finalist& f) { return f.bent.has_value(); });
  if (laid != finalists.end()) add(static_cast<int>(laid - finalists.begin()));
  return leading;
}

RefinedAnswers::RefinedAnswers(const std::vector<RefinedMap>& refined,
                               const std::vector<Finalist>& finalists,
                               const TriangleMesh& coarse_target,
                               const TriangleMesh& target,
                               double gap)
    : refined_(refined),
      finalists_(finalists),
      coarse_target_(coarse_target),
      target_(target),
      gap_(gap) {}

const RefinedMap* RefinedAnswers::of(int finalist) const {
  const auto found = std::find_if(refined_.begin(), refined_.end(), [&](const RefinedMap& map) {
    return gapBetween(coarse_target_, finalists_[map.finalist].maps, finalists_[finalist].maps) <=
           gap_;
  });
  return found == refined_.end() ? nullptr : &*found;
}

bool RefinedAnswers::becameBest(int finalist) const {
  const RefinedMap& best = refined_.front();
  const RefinedMap* map = of(finalist);
  return map != nullptr && map != of(best.finalist) &&
         gapBetween(target_, map->pair.maps, best.pair.maps) <= gap_;
}

}  // namespace posture
