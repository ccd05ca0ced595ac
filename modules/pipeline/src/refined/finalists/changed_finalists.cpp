// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finalists/changed_finalists.h"

#include <posture/core/parallel.h>
#include <posture/refine/grow_anew.h>
#include <posture/refine/let_go.h>
#include <posture/refine/settle.h>

#include "answer/verdict.h"
#include "refined/finalists/answer_gap.h"
#include "refined/finalists/by_score.h"
#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// How many different answers are tried without what they misplace.
constexpr int MOST_LOOSENED = 8;

/// How many different answers are grown anew, how many are turned, and of how many of what comes of
/// either parts are let go.
constexpr std::size_t MOST_GROWN_FROM = 4, MOST_TURNED_FROM = 3, MOST_CHANGED = 6;

/// Of a surface onto itself: maps of samples, and those that keep the outside out.
constexpr int MOST_SYMMETRIES = 8;
constexpr std::size_t MOST_TURNS = 3;

/// A finalist's map with both surfaces bent; what is laid anew of them settles as softly as they do
/// at the last.
BentPair bentPair(const SpectralSurface& source,
                  const SpectralSurface& target,
                  double softness,
                  const Finalist& finalist) {
  if (finalist.bent) return *finalist.bent;
  const VertexMaps& maps = finalist.maps;
  BentPair pair{maps,
                target.mesh.vertices(maps.forward, Eigen::all),
                source.mesh.vertices(maps.backward, Eigen::all)};
  for (std::size_t k = 0; k + 1 < SETTLING.size(); ++k)
    settle(source, target, SETTLING[k] * softness, SETTLING_ROUNDS, pair);
  return pair;
}

/// The score that changing a finalist's map has to beat: its own, or that of its bent surfaces once
/// they have settled. What settling alone gains, no change did.
double scoreToBeat(const SpectralSurface& source,
                   const SpectralSurface& target,
                   double softness,
                   const Finalist& finalist,
                   BentPair pair) {
  settleSoftening(source, target, softness, pair, SETTLING.size() - 1);
  return std::min(finalist.score.total(), scoreBent(source, target, pair, false).total());
}

/// The finalist with another map, if that looks like one body and keeps the outside out.
std::optional<Finalist> withMap(const SpectralSurface& source,
                                const SpectralSurface& target,
                                BentPair pair,
                                const MapScore& score,
                                Finalist finalist) {
  if (!convinces(score.total())) return {};
  finalist.orientation = orientation(source, target, pair.maps);
  if (finalist.orientation <= LEAST_ORIENTATION) return {};
  finalist.score = score;
  finalist.maps = pair.maps;
  finalist.bent = std::move(pair);
  return finalist;
}

/// Those that there are, and the others, by increasing score.
std::vector<Finalist> joined(std::vector<std::optional<Finalist>> some,
                             std::vector<Finalist> others) {
  std::vector<Finalist> there;
  for (std::optional<Finalist>& one : some)
    if (one) there.push_back(std::move(*one));
  return joined(std::move(there), std::move(others));
}

/// What was made of a finalist.
struct Changed {
  Finalist from;
  BentPair pair;
  MapScore score;
  bool is_known = false;  ///< the answer of another finalist, in a better state
};

/// What work that bends surfaces gives, an optional; none where they are too torn to be bent.
template <class Work>
auto ifBendable(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const TornSurface&) {
    return std::nullopt;
  }
}

/// The first different finalists followed by turns, those that lead elsewhere; no surface bent.
std::vector<Finalist> followedBy(const Turns& turns,
                                 const TriangleMesh& target,
                                 const std::vector<int>& distinct,
                                 double gap,
                                 const std::vector<Finalist>& finalists) {
  std::vector<Finalist> followed;
  const auto add = [&](const Finalist& finalist, VertexMaps maps) {
    const auto same = [&](const Finalist& other) {
      return gapBetween(target, maps, other.maps) <= gap;
    };
    if (std::any_of(followed.begin(), followed.end(), same)) return;
    followed.push_back(finalist);
    followed.back().maps = std::move(maps);
    followed.back().bent.reset();
  };
  for (std::size_t k = 0; k < std::min(MOST_TURNED_FROM, distinct.size()); ++k) {
    const Finalist& finalist = finalists[distinct[k]];
    for (const VertexMaps& turn : turns.source) add(finalist, composed(turn, finalist.maps));
    for (const VertexMaps& turn : turns.target) add(finalist, composed(finalist.maps, turn));
  }
  return followed;
}

/// Finalists, and the best of what was made of them, new answers with what they misplace let go of:
/// of known ones less of the body always fits a little better.
std::vector<Finalist> withBestOf(const SpectralSurface& source,
                                 const SpectralSurface& target,
                                 double softness,
                                 std::vector<Changed> changed,
                                 std::vector<Finalist> finalists) {
  sortByScore(changed);
  changed.resize(std::min(MOST_CHANGED, changed.size()));
  std::vector<std::optional<Finalist>> better(changed.size());
  parallelFor(static_cast<int>(changed.size()), [&](int i) {
    const Changed& one = changed[i];
    better[i] = ifBendable([&] {
      BentPair pair = one.pair;
      std::optional<MapScore> less;
      if (!one.is_known) less = letGo(source, target, softness, SCORE_NOISE, pair);
      return withMap(source, target, std::move(pair), less.value_or(one.score), one.from);
    });
  });
  return joined(std::move(better), std::move(finalists));
}

}  // namespace

std::vector<Finalist> withPartsLetGo(const SpectralSurface& source,
                                     const SpectralSurface& target,
                                     const std::vector<int>& distinct,
                                     std::vector<Finalist> finalists) {
  std::vector<Finalist> tried;
  for (int i : distinct)
    if (static_cast<int>(tried.size()) < MOST_LOOSENED && !finalists[i].laid)
      tried.push_back(finalists[i]);
  const double softness = settlingSoftness(source, target);
  std::vector<std::optional<Finalist>> loose(tried.size());
  parallelFor(static_cast<int>(tried.size()), [&](int i) {
    loose[i] = ifBendable([&]() -> std::optional<Finalist> {
      BentPair pair = bentPair(source, target, softness, tried[i]);
      const BentPair before = pair;
      const std::optional<MapScore> score = letGo(source, target, softness, SCORE_NOISE, pair);
      if (!score ||
          score->total() >= scoreToBeat(source, target, softness, tried[i], before) - SCORE_NOISE)
        return std::nullopt;
      return withMap(source, target, std::move(pair), *score, tried[i]);
    });
  });
  return joined(std::move(loose), std::move(finalists));
}

std::vector<Finalist> withPartsGrownAnew(const SpectralSurface& source,
                                         const SpectralSurface& target,
                                         const std::vector<int>& distinct,
                                         double gap,
                                         std::vector<Finalist> finalists) {
  const double softness = settlingSoftness(source, target);
  std::vector<Changed> grown;
  const auto near = std::count_if(distinct.begin(), distinct.end(), [&](int i) {
    return mayConvince(finalists[i].score.total());
  });
  struct Begun {
    const Finalist* finalist;
    BentPair pair;
    double before;
  };
  std::vector<std::optional<Begun>> tried(
      std::min(MOST_GROWN_FROM, static_cast<std::size_t>(near)));
  parallelFor(static_cast<int>(tried.size()), [&](int k) {
    tried[k] = ifBendable([&]() -> std::optional<Begun> {
      const Finalist& finalist = finalists[distinct[k]];
      const BentPair pair = bentPair(source, target, softness, finalist);
      return Begun{&finalist, pair, scoreToBeat(source, target, softness, finalist, pair)};
    });
  });
  std::vector<Begun> begun;
  for (std::optional<Begun>& one : tried)
    if (one) begun.push_back(std::move(*one));
  for (const Begun& from : begun)
    for (ScoredPair& one : growAnew(source, target, softness, begun.front().pair, from.pair)) {
      // The same answer once more, less of the body mapped, is no better.
      double known = from.before;
      for (const Begun& other : begun)
        if (gapBetween(target.mesh, one.pair, other.pair) <= gap)
          known = std::min(known, other.before);
      if (one.score.total() < known - SCORE_NOISE)
        grown.push_back({*from.finalist, std::move(one.pair), one.score, false});
    }
  return withBestOf(source, target, softness, std::move(grown), std::move(finalists));
}

std::vector<VertexMaps> turnsOntoItself(const SpectralSurface& surface,
                                        const SampledShape& samples) {
  const double gap = answerGap(samples);
  VertexMaps identity;
  identity.forward.resize(surface.mesh.vertices.rows());
  std::iota(identity.forward.begin(), identity.forward.end(), 0);
  identity.backward = identity.forward;
  std::vector<VertexMaps> turns;
  for (const Finalist& finalist : registerFinalists(
           surface, surface, samples, samples, symmetries(samples, MOST_SYMMETRIES))) {
    const auto same = [&](const VertexMaps& other) {
      return gapBetween(surface.mesh, finalist.maps, other) <= gap;
    };
    if (same(identity) || std::any_of(turns.begin(), turns.end(), same)) continue;
    turns.push_back(finalist.maps);
    if (turns.size() == MOST_TURNS) break;
  }
  return turns;
}

std::vector<Finalist> withTurned(const SpectralSurface& source,
                                 const SpectralSurface& target,
                                 const Turns& turns,
                                 const std::vector<int>& distinct,
                                 double gap,
                                 std::vector<Finalist> finalists) {
  const double softness = settlingSoftness(source, target);
  const std::vector<Finalist> begun = followedBy(turns, target.mesh, distinct, gap, finalists);
  std::vector<std::optional<Changed>> settled(begun.size());
  parallelFor(static_cast<int>(settled.size()), [&](int i) {
    settled[i] = ifBendable([&]() -> std::optional<Changed> {
      BentPair pair = bentPair(source, target, softness, begun[i]);
      settle(source, target, softness, SETTLING_ROUNDS, pair);
      const MapScore score = scoreBent(source, target, pair, false);
      return Changed{begun[i], std::move(pair), score, false};
    });
  });
  std::vector<Changed> turned;
  for (std::optional<Changed>& one : settled) {
    if (!one) continue;
    bool is_better = true;
    for (int i : distinct) {
      if (gapBetween(target.mesh, finalists[i].maps, one->pair.maps) > gap) continue;
      one->is_known = true;
      is_better = is_better && one->score.total() < finalists[i].score.total() - SCORE_NOISE;
    }
    if (is_better) turned.push_back(std::move(*one));
  }
  return withBestOf(source, target, softness, std::move(turned), std::move(finalists));
}

}  // namespace posture
