// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>
#include <posture/refine/map_score.h>
#include <posture/refine/surface.h>

#include <optional>
#include <vector>

namespace posture {

/// Share of the area that a map takes somewhere. Where more of it is misplaced, not a part is wrong
/// but the map.
constexpr double MOST_LET_GO = 0.5;

/// The vertices of a around which a map changes distances along the surface by far more than
/// elsewhere: a head is squeezed onto the neck where the other surface ends there.
/// \param apart  vertices whose matches do not count, as in BentPair; what is apart has the
///               mark of the nearest place that is not.
/// \pre  any prefix of a's vertices is spread evenly (as reduceMesh() orders them), and both
///       surfaces are in a unit of about the square root of their area.
std::vector<char> misplaced(const SpectralSurface& a,
                            const SpectralSurface& b,
                            const std::vector<int>& matches,
                            const std::vector<char>& apart);

/// Takes what is misplaced on either surface out of the map, lays it as the surface around it goes,
/// and lets both settle: what then lies on the other surface is matched with that, the rest is
/// apart. Again while more is misplaced and the score gets better.
///
/// \param softness  as for anneal().
/// \param least_gain  of the score, each time.
/// \return  the score, if it gains that; nothing otherwise, and `pair` is as it was.
std::optional<MapScore> letGo(const SpectralSurface& a,
                              const SpectralSurface& b,
                              double softness,
                              double least_gain,
                              BentPair& pair);

}  // namespace posture
