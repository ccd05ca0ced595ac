// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>
#include <posture/refine/map_score.h>
#include <posture/refine/partners.h>

#include "refined/finalists/finalists.h"
#include "refined/work/refined_shape.h"
#include <vector>

namespace posture {

/// A map between the work meshes with what speaks against it.
struct RefinedMap {
  int finalist = 0;  ///< index of the one it was made of
  double scale = 1;  ///< what the source was multiplied by for it
  HowFound found;    ///< what withoutPartner() asks
  BentPair pair;
  MapScore score;
  /// By how much worse ends of limbs fit than under the map, of those it was compared with, under
  /// which they fit best (endDisagreements()): says nothing of maps it was not compared with.
  double ends = 0;
  double hands = 0;  ///< what it pays for hands on the other side; 0 where none was looked at

  /// What it is known for right by. Lower is better.
  double likeness() const { return score.total() + hands; }

  /// What maps that were refined together are compared by. Lower is better.
  double judged() const { return likeness() + ends; }
};

/// Takes finalists to the work meshes, settled there, and compares them; the best first.
/// \param may_lack  whether a side may lack a part that the other one has: what a map squeezes so
///                  badly that its score says nothing of the rest is then let go of.
/// \throws TornSurface  a surface is too torn to be bent, by any of them
std::vector<RefinedMap> refineFinalists(const RefinedShape& source,
                                        const RefinedShape& target,
                                        bool may_lack,
                                        const std::vector<const Finalist*>& finalists);

/// Makes a map as exact as the work meshes allow: limbs are turned about themselves where they fit
/// better so, all is annealed, ends of limbs that do not fit are laid anew where that makes the
/// limb lie better, and what is misplaced is let go of. Limbs are not turned where something was
/// let go of before. The score stays what it is compared by. Maps of surfaces that were laid over
/// each other stay as they are, and where a surface is too torn for one of these steps it is left
/// out. \param may_lack  as for refineFinalists(): if not, nothing is let go of.
void annealMap(const RefinedShape& source,
               const RefinedShape& target,
               bool may_lack,
               RefinedMap& map);

}  // namespace posture
