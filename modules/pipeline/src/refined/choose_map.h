// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "answer/known_answer.h"
#include "refined/first_maps.h"
#include "stage_clock.h"
#include <vector>

namespace posture {

/// The stage refinement: of finalists, the way to the best of those that are refined.
/// \param found  by increasing score; none leaves the source where it is, without a map.
void chooseAmong(const FirstMaps& first_maps, std::vector<Finalist> found, StageClock& clock);

/// The stages from tips to refinement: the way from the first maps to the best of the refined ones.
/// \return  whether there is a choice; not where it stopped before maps are refined, as the known
/// answer stands.
bool chooseMap(const FirstMaps& first_maps, const KnownAnswer& known, StageClock& clock);

}  // namespace posture
