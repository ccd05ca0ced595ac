// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>
#include <posture/refine/surface.h>

#include <vector>

namespace posture {

/// A limb turned about itself: its end as a whole, what lies between end and body in proportion. A
/// full turn leaves the end as it was and winds the limb the other way round.
struct LimbTurn {
  double angle = 0;  ///< of the end, in radians, about the way from body to tip
  double end = 0;    ///< distance from the tip up to which all turns as a whole
  double body = 1;   ///< from which on nothing turns; more than `end`
};

/// Where a limb is turned wrongly about itself no surface gets out of that by settling: a palm lies
/// where the back of the hand belongs, or a forearm is wound by 190 degrees where it should be
/// -170. Half and whole turns are tried on the limb alone, which then settles.
/// \param tip   a vertex of a, the end of a limb.
/// \param pair  as the surfaces lie so far, in a unit of about the square roots of their areas.
/// \return  at most `most` turns, the best first, after which the limb fits about as well as before
///          or better; none where there is no limb to speak of.
std::vector<LimbTurn> likelyTurns(const SpectralSurface& a,
                                  const SpectralSurface& b,
                                  int tip,
                                  double softness,
                                  const BentPair& pair,
                                  std::size_t most);

/// Turns the limb that ends at `tip` as that of the `turns` says with which it fits best, unless it
/// fits better without.
/// \return  whether it was turned; `pair` then has the limb's new matches and places, and the rest
///          is left to settle().
bool turnLimb(const SpectralSurface& a,
              const SpectralSurface& b,
              int tip,
              double softness,
              const std::vector<LimbTurn>& turns,
              BentPair& pair);

/// Lays the limb at `tip` anew where its end, a hand, a foot or a head, does not fit: as it is,
/// with the end turned by quarters of a turn, and as it fits as a rigid body if it does so in one
/// way only (rigidEnds()). The end alone is judged: what the limb below is then wound by is gone
/// only when all has settled for long.
///
/// \param tip  a vertex of a, the end of a limb.
/// \param softness  as for anneal().
/// \param pair  annealed but for the ends of other limbs, in a unit of about the square roots of
///              the areas; to be annealed again afterwards.
/// \return  whether the end now fits clearly better; otherwise `pair` is as it was.
bool refitLimbEnd(
    const SpectralSurface& a, const SpectralSurface& b, int tip, double softness, BentPair& pair);

/// Whether the limb at `tip`, with what is around it, lies better on its matches after its end was
/// laid anew and all was annealed again. A head that turned in its skin drew each ear onto the
/// other one. How it is bent does not count: a limb may be wound by a turn that is right.
/// \param tip  a vertex of a, the end of a limb.
bool limbFitsBetter(const SpectralSurface& a,
                    const SpectralSurface& b,
                    int tip,
                    double softness,
                    const BentPair& before,
                    const BentPair& after);

}  // namespace posture
