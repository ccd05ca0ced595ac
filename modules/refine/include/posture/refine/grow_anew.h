// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/scored_pair.h>
#include <posture/refine/surface.h>

#include <vector>

namespace posture {

/// Where parts of a body are missing, maps come to be right on one part of it and wrong on the
/// next: a trunk is wound by half a turn, an arm lies on the other one. Nothing that settles leaves
/// such a state. Keeps a part of the map, lays the rest as that part goes, and lets both surfaces
/// settle: once each with what is around one of several places kept.
///
/// \pre  any prefix of a's vertices is spread evenly (as reduceMesh() orders them), and both
///       surfaces are in a unit of about the square root of their area.
/// \param softness  as for anneal().
/// \param best  the best map known, or `pair`: limbs that the part kept does not lead to are taken
///        from it where it goes on from what has grown.
/// \return  one for each part kept, without those that leave more than MOST_LET_GO apart. Which of
///          them is right, if any, the score has to tell.
std::vector<ScoredPair> growAnew(const SpectralSurface& a,
                                 const SpectralSurface& b,
                                 double softness,
                                 const BentPair& best,
                                 const BentPair& pair);

}  // namespace posture
