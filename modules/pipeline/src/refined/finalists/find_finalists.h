// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "answer/known_answer.h"
#include "refined/finalists/finalists.h"
#include "refined/work/posed_side.h"
#include "stage_clock.h"
#include <optional>
#include <vector>

namespace posture {

/// What the stages before refinement work on: two sides at one scale and their coarse surfaces.
struct CoarseSides {
  const PosedSide &source_side, &target_side;
  const SpectralSurface &source, &target;
};

/// The bending stage: maps between the coarse surfaces that keep the outside out, by increasing
/// score.
/// \param pool  sample maps, by increasing distortion.
/// \throws TornSurface  a surface cannot be bent
std::vector<Finalist> bentFinalists(const CoarseSides& sides,
                                    const std::vector<SampleMap>& pool,
                                    StageClock& clock);

/// The stages from tips to laying over: what else is found where the bent maps do not tell.
/// \param finalists  bentFinalists().
/// \param may_lack  whether a side may lack a part that the other one has.
/// \return  maps between the coarse surfaces, by increasing score; none: the known answer stands
///
/// \throws TornSurface  a surface cannot be bent
std::optional<std::vector<Finalist>> findFinalists(const CoarseSides& sides,
                                                   std::vector<Finalist> finalists,
                                                   bool may_lack,
                                                   const KnownAnswer& known,
                                                   StageClock& clock);

}  // namespace posture
