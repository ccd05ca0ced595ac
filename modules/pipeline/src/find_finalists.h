// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "finalists.h"
#include "posed_side.h"
#include "stage_clock.h"
#include <optional>
#include <vector>

namespace posture {

/// The bending stage: maps between the coarse surfaces that keep the outside out, by increasing
/// score.
/// \param source, target  at one scale.
/// \param pool  sample maps, by increasing distortion.
/// \throws std::runtime_error  a surface cannot be bent (Arap)
std::vector<Finalist> bentFinalists(const SpectralSurface& source,
                                    const SpectralSurface& target,
                                    const SampledShape& source_samples,
                                    const SampledShape& target_samples,
                                    const std::vector<SampleMap>& pool,
                                    StageClock& clock);

/// The stages from tips to laying over: what else is found where the bent maps do not tell.
/// \param source_side, target_side  at one scale.
/// \param source, target  their coarse surfaces.
/// \param finalists  bentFinalists().
/// \param may_lack  whether a side may lack a part that the other one has.
/// \param known  an answer found otherwise, in the numbering of both inputs; null: none.
/// \param may_stop  whether to end as soon as that is confirmed and stands (knownStands()).
/// \return  maps between the coarse surfaces, by increasing score; nothing: it ended so.
/// \throws std::runtime_error  a surface cannot be bent (Arap)
std::optional<std::vector<Finalist>> findFinalists(const PosedSide& source_side,
                                                   const PosedSide& target_side,
                                                   const SpectralSurface& source,
                                                   const SpectralSurface& target,
                                                   std::vector<Finalist> finalists,
                                                   bool may_lack,
                                                   const RegistrationResult* known,
                                                   bool may_stop,
                                                   StageClock& clock);

}  // namespace posture
