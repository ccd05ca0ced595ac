// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/chosen_map.h"
#include "refined/finalists/find_finalists.h"
#include "sides/given_shape.h"
#include "stage_clock.h"
#include <memory>
#include <vector>

namespace posture {

/// What there is once surfaces are bent onto each other: the first maps, between the coarse ones.
struct FirstMaps {
  FirstMaps(const GivenShape& source, const GivenShape& target)
      : chosen(std::make_shared<ChosenMap>(source, target)) {}

  std::shared_ptr<ChosenMap> chosen;
  std::unique_ptr<const SpectralSurface> source_coarse, target_coarse;
  std::vector<Finalist> bent;  ///< by increasing score

  /// Brings both sides to one scale.
  void scale(double ratio);

  CoarseSides coarseSides() const {
    return {chosen->source, chosen->target, *source_coarse, *target_coarse};
  }
};

/// The stages reduction, spectrum and geodesic: the surfaces as they are worked on, smooth
/// functions on them, and samples. There are no maps yet, and no common scale.
FirstMaps preparedSides(const GivenShape& source_given,
                        const GivenShape& target_given,
                        StageClock& clock);

/// These and the stages candidates and bending: the way from the surfaces to the first maps.
/// \throws TornSurface  a surface cannot be bent
FirstMaps firstMaps(const GivenShape& source_given,
                    const GivenShape& target_given,
                    StageClock& clock);

}  // namespace posture
