// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finalists/find_finalists.h"

#include <posture/refine/tip_maps.h>

#include "answer/same_answer.h"
#include "answer/shared_verdict.h"
#include "answer/verdict.h"
#include "refined/finalists/answer_gap.h"
#include "refined/finalists/by_score.h"
#include "refined/finalists/changed_finalists.h"
#include "refined/finalists/distinct_finalists.h"
#include "refined/finalists/end_maps.h"
#include "refined/work/coarse_map.h"
#include <utility>

namespace posture {
namespace {

constexpr int MOST_TIP_MAPS = 8;

/// Finalists, and what is found beside them where they do not tell, a stage a function.
class FinalistSearch {
 public:
  FinalistSearch(const CoarseSides& sides,
                 std::vector<Finalist> finalists,
                 const KnownAnswer& known,
                 StageClock& clock)
      : sides_(sides), known_(known), clock_(clock), found_(std::move(finalists)) {
    lookAgain();
  }

  std::vector<Finalist> take() { return std::move(found_); }

  /// The known answer is believed, and the best finalist leads everywhere to where it does.
  bool confirmsKnown() const { return confirms_; }

  /// So that nothing more need be sought.
  bool knownSuffices() const { return suffices_; }

  bool convinces() const { return anyConvincesWhole(found_); }

  bool isAllButCertain() const { return posture::isAllButCertain(found_, distinct()); }

  /// Those that take tips of limbs to tips of limbs; then those that lay ends as they fit.
  void addTips() {
    run("tips", [&] {
      found_ = joined(std::move(found_),
                      registered(tipMaps(sourceSamples(), targetSamples(), MOST_TIP_MAPS)));
      bendFurther(sides_.source, sides_.target, found_);
      exchangeParts(sides_.source, sides_.target, gap(), found_);
      layEndsAsTheyFit();
    });
  }

  /// A part that the other side lacks is squeezed onto what there is, and leads what is next to it
  /// astray.
  void letGo() {
    run("letting go", [&] {
      const std::vector<int> different = distinct();
      found_ = withPartsLetGo(sides_.source, sides_.target, different, std::move(found_));
    });
  }

  void growAnew() {
    run("growing anew", [&] {
      const std::vector<int> different = distinct();
      found_ =
          withPartsGrownAnew(sides_.source, sides_.target, different, gap(), std::move(found_));
    });
  }

  void turn() {
    run("turning", [&] {
      const std::vector<int> different = distinct();
      found_ = withTurned(sides_.source,
                          sides_.target,
                          {turnsOntoItself(sides_.source, sourceSamples()),
                           turnsOntoItself(sides_.target, targetSamples())},
                          different,
                          gap(),
                          std::move(found_));
    });
  }

  void layOver() {
    run("laying over", [&] {
      found_ = joined(std::move(found_),
                      layFinalists(sides_.source,
                                   sides_.target,
                                   sides_.source_side.coarsePlaces(),
                                   sides_.target_side.coarsePlaces()));
    });
  }

 private:
  const SampledShape& sourceSamples() const { return sides_.source_side.shape.samples; }
  const SampledShape& targetSamples() const { return sides_.target_side.shape.samples; }
  double gap() const { return answerGap(targetSamples()); }

  std::vector<int> distinct() const { return distinctFinalists(found_, sides_.target.mesh, gap()); }

  std::vector<Finalist> registered(const std::vector<SampleMap>& maps) const {
    return registerFinalists(sides_.source, sides_.target, sourceSamples(), targetSamples(), maps);
  }

  template <class Change>
  void run(const char* stage, const Change& change) {
    constexpr double PORTION = 0.03;
    clock_.stage(stage, PORTION, change);
    lookAgain();
  }

  void lookAgain() {
    confirms_ = leadsWhereKnown();
    suffices_ =
        known_.may_stop && confirms_ && knownStands(*known_.result, found_.front().score.total());
  }

  bool leadsWhereKnown() const;
  void layEndsAsTheyFit();

  const CoarseSides& sides_;
  const KnownAnswer& known_;
  StageClock& clock_;
  std::vector<Finalist> found_;  ///< by increasing score
  bool confirms_ = false, suffices_ = false;
};

bool FinalistSearch::leadsWhereKnown() const {
  if (known_.result == nullptr || known_.result->status != Status::REGISTERED || found_.empty())
    return false;
  const Finalist& best = found_.front();
  const std::vector<char> apart = best.bent ? best.bent->apart_a : std::vector<char>();
  const PosedSide &source = sides_.source_side, &target = sides_.target_side;
  const CleanMesh& clean = source.given.clean;
  const RefinedShape& shape = source.shape;
  const std::vector<int> places =
      coarseToInput(best.maps, source.given, shape, target.given, target.shape);
  std::vector<SurfacePoint> on_target(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    const int coarse = shape.coarse.nearest[shape.work.nearest[clean.clean_vertex[v]]];
    const bool is_mapped = clean.isOnMain(static_cast<Eigen::Index>(v)) && !isApart(apart, coarse);
    if (is_mapped) on_target[v].vertex = places[v];
  }
  return agreeEverywhere(
      known_.result->correspondence.on_target, on_target, target.given.input, 1 / target.pose.unit);
}

void FinalistSearch::layEndsAsTheyFit() {
  const std::vector<SampleMap> maps = endMaps(sides_.source_side.shape,
                                              sides_.target_side.shape,
                                              sides_.source,
                                              sides_.target,
                                              found_,
                                              distinct());
  if (maps.empty()) return;
  std::vector<Finalist> fitting = registered(maps);
  bendFurther(sides_.source, sides_.target, fitting);
  // Parts are exchanged with the best one before alone: with the others they have been.
  fitting.push_back(std::move(found_.front()));
  found_.erase(found_.begin());
  sortByScore(fitting);
  exchangeParts(sides_.source, sides_.target, gap(), fitting);
  found_ = joined(std::move(found_), std::move(fitting));
}

}  // namespace

std::vector<Finalist> bentFinalists(const CoarseSides& sides,
                                    const std::vector<SampleMap>& pool,
                                    StageClock& clock) {
  // Those that keep the outside out, bent onto the target; the least strained first.
  return clock.stage("bending", 0.1, [&] {
    const SampledShape &source_samples = sides.source_side.shape.samples,
                       &target_samples = sides.target_side.shape.samples;
    std::vector<Finalist> bent =
        registerFinalists(sides.source, sides.target, source_samples, target_samples, pool);
    exchangeParts(sides.source, sides.target, answerGap(target_samples), bent);
    return bent;
  });
}

std::optional<std::vector<Finalist>> findFinalists(const CoarseSides& sides,
                                                   std::vector<Finalist> finalists,
                                                   bool may_lack,
                                                   const KnownAnswer& known,
                                                   StageClock& clock) {
  FinalistSearch search(sides, std::move(finalists), known, clock);
  if (search.knownSuffices()) return std::nullopt;

  // Where bodies stretch, the right candidate is not among those that change distances least, nor
  // where they lack parts.
  if (!search.convinces() || (may_lack && !search.confirmsKnown() && !search.isAllButCertain())) {
    search.addTips();
    if (search.knownSuffices()) return std::nullopt;
  }

  if (may_lack && !search.confirmsKnown()) {
    search.letGo();
    if (search.knownSuffices()) return std::nullopt;
    // With holes closed the map is wanted for what it does not lose.
    const bool as_given =
        !sides.source_side.given.is_patched && !sides.target_side.given.is_patched;
    if (as_given && !search.confirmsKnown()) {
      search.growAnew();
      search.turn();
    }
  }

  // Spectra and scale go astray where much is missing; surfaces laid over each other do not.
  if (!search.convinces()) search.layOver();
  return search.take();
}

}  // namespace posture
