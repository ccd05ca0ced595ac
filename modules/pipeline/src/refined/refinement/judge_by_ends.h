// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/refinement/refined_maps.h"
#include "refined/refinement/work_surfaces.h"
#include <vector>

namespace posture {

/// Where maps are different answers, compares them by how ends of limbs fit, too
/// (RefinedMap::ends), and sorts them by both: a body that is half turned has each hand on the
/// other one. A map that let go of an end which fits under another one pays for it. Maps of one
/// answer are judged by its best.
/// \param may_lack  whether a side may lack a part that the other one has: hands then tell of each
///                  answer by itself, too (RefinedMap::hands), as the right one may not be there.
/// \param maps  by increasing score; the best first.
void judgeByEnds(const RefinedShape& source,
                 const RefinedShape& target,
                 const WorkSurfaces& surfaces,
                 bool may_lack,
                 std::vector<RefinedMap>& maps);

}  // namespace posture
