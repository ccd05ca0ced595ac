// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/scored_pair.h>
#include <posture/refine/surface.h>

namespace posture {

/// Where a map is known on a part of both surfaces: lays what is apart as the surface around it
/// goes and takes in, strip after strip from where the map ends, what then lies on the other
/// surface, which settles each time; so limbs that bend are followed. Then draws both surfaces as a
/// whole onto what is nearest, which mends a known map that had slid and spoils one whose limbs
/// bend far; that is kept if more is mapped then, and the score is not worse by far. What is
/// misplaced in the end is let go of.
///
/// \pre  any prefix of a surface's vertices is spread evenly (as reduceMesh() orders them), and
///       both are in a unit of about the square root of their area.
/// \param softness  as for anneal().
/// \throws TornSurface  a surface is too torn to be bent
ScoredPair extendMap(const SpectralSurface& a,
                     const SpectralSurface& b,
                     double softness,
                     BentPair pair);

}  // namespace posture
