// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/refine/turn_limbs.h>

#include "limb_pair.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace posture {
namespace {

/// Lengths in square roots of the area: a hand or a foot turns as a whole, and what is beyond the
/// elbow, or beyond the shoulder, does not. A whole turn between hand and shoulder never was right.
constexpr std::array<LimbTurn, 6> TURNS{{{M_PI, 0.1, 0.35},
                                         {-M_PI, 0.1, 0.35},
                                         {2 * M_PI, 0.1, 0.35},
                                         {-2 * M_PI, 0.1, 0.35},
                                         {M_PI, 0.15, 0.6},
                                         {-M_PI, 0.15, 0.6}}};

/// How far from its tip a limb is looked at: an arm with the shoulder.
constexpr double REACH = 0.7;

/// Of the misfit as it is. What is right on a finer mesh had at most 1.012 of it on the coarse one.
constexpr double NEARLY_AS_GOOD = 1.02;

/// A hand or a hoof is turned as a whole, and what follows it up to one of these distances from the
/// tip takes the turn up.
constexpr std::array<double, 2> JOINTS{0.25, 0.35};
constexpr std::array<double, 4> END_ANGLES{M_PI / 2, -M_PI / 2, M_PI, -M_PI};

/// How far beyond what turns a limb is looked at.
constexpr double MARGIN = 0.1;

/// The end of a limb by which turns of it are judged.
constexpr double END = 0.2;

/// Vertices of an end on either side. A tail of six vertices around fits where those of both meshes
/// happen to fall on each other: of six ends with 36 to 47 vertices four were turned wrongly, of
/// those with 74 and more next to none.
constexpr std::size_t FEWEST_TO_JUDGE = 64;

/// Of the limb's misfit unturned, both settled for a short while. What was right had at most 0.964
/// of it, what was wrong at times 0.76.
constexpr double WORTH_ANNEALING = 0.97;

/// Of the end's misfit unturned, annealed as well. Annealing what fits again changes it by up to
/// 0.08; of the turns tried on 25 pairs none that left less than 0.9 was wrong.
constexpr double CLEARLY_BETTER = 0.9;

/// Where a limb laid anew without a turn leaves less than this of the end's misfit, that is mostly
/// not a matter of turns (a tip without a counterpart, a torn limb), and a turn has to take it
/// below this much again. Where turns of scanned and modelled bodies were right it left 0.66 and
/// more, on two pairs that were turned wrongly 0.33 and 0.09.
constexpr double ANOTHER_MATTER = 0.5;

/// The end of a limb of both surfaces.
class EndPair {
 public:
  EndPair(const SpectralSurface& a,
          const SpectralSurface& b,
          int tip,
          double softness,
          const BentPair& pair)
      : whole_a_(a),
        whole_b_(b),
        a_(limbAt(a, tip, END)),
        b_(limbAt(b, pair.maps.forward[tip], END)),
        softness_(softness) {}

  /// Whether there is enough of it to tell which way it is turned.
  bool isEnd() const { return std::min(a_.vertex.size(), b_.vertex.size()) >= FEWEST_TO_JUDGE; }

  /// \param pair  of the whole surfaces.
  double misfit(const BentPair& pair) const {
    return oneWayMisfit(whole_a_, {a_.vertex, a_.surface->arap}, whole_b_, softness_, pair) +
           oneWayMisfit(
               whole_b_, {b_.vertex, b_.surface->arap}, whole_a_, softness_, reversed(pair));
  }

 private:
  const SpectralSurface &whole_a_, &whole_b_;
  Limb a_, b_;
  double softness_;
};

}  // namespace

std::vector<LimbTurn> likelyTurns(const SpectralSurface& a,
                                  const SpectralSurface& b,
                                  int tip,
                                  double softness,
                                  const BentPair& pair,
                                  std::size_t most) {
  const LimbPair limb(a, b, tip, REACH, softness, pair);
  if (!limb.isLimb()) return {};
  std::vector<LimbTurn> likely;
  for (const Trial& trial : trials(limb, {TURNS.begin(), TURNS.end()}))
    if (likely.size() < most && trial.misfit < NEARLY_AS_GOOD) likely.push_back(trial.turn);
  return likely;
}

bool turnLimb(const SpectralSurface& a,
              const SpectralSurface& b,
              int tip,
              double softness,
              const std::vector<LimbTurn>& turns,
              BentPair& pair) {
  if (turns.empty()) return false;
  const LimbPair limb(a, b, tip, REACH, softness, pair);
  if (!limb.isLimb()) return false;
  const Trial best = trials(limb, turns).front();
  if (!(best.misfit < 1)) return false;
  limb.putInto(best.limb, pair);
  return true;
}

bool turnLimbEnd(
    const SpectralSurface& a, const SpectralSurface& b, int tip, double softness, BentPair& pair) {
  const EndPair end(a, b, tip, softness, pair);
  if (!end.isEnd()) return false;
  const double in_place = end.misfit(pair);
  double unturned = in_place, least = std::numeric_limits<double>::infinity();
  BentPair best;
  for (double joint : JOINTS) {
    const LimbPair limb(a, b, tip, joint + MARGIN, softness, pair);
    if (!limb.isLimb()) continue;
    std::vector<LimbTurn> turns;
    for (double angle : END_ANGLES) turns.push_back({angle, 0.1, joint});
    std::vector<BentPair> likely;
    for (Trial& trial : trials(limb, turns))
      if (trial.misfit < WORTH_ANNEALING) likely.push_back(std::move(trial.limb));
    if (likely.empty()) continue;
    likely.push_back(limb.tried({}));
    std::vector<BentPair> wholes(likely.size(), pair);
    std::vector<double> misfits(likely.size(), std::numeric_limits<double>::infinity());
    parallelFor(static_cast<int>(likely.size()), [&](int k) {
      try {
        limb.putInto(limb.annealed(likely[k]), wholes[k]);
        misfits[k] = end.misfit(wholes[k]);
      } catch (const std::runtime_error&) {  // a crumb of the limb that nothing holds
      }
    });
    unturned = std::min(unturned, misfits.back());
    for (std::size_t k = 0; k + 1 < likely.size(); ++k)
      if (misfits[k] < least) {
        least = misfits[k];
        best = std::move(wholes[k]);
      }
  }
  if (!std::isfinite(in_place)) return false;
  const double enough = unturned < ANOTHER_MATTER * in_place ? ANOTHER_MATTER : CLEARLY_BETTER;
  if (!(least < enough * unturned)) return false;
  pair = std::move(best);
  return true;
}

}  // namespace posture
