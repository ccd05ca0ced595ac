// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/scan/reconstruct.h>

#include "clean/inside_boundary.h"
#include "points/orientation.h"
#include <optional>

namespace posture {

/// The surface of points that have no noise to speak of, as the vertices of a mesh have none: every
/// point but outliers a vertex where possible, however unevenly they lie. Nothing when the points
/// are noisy, too many or in a plane, or when what comes out is no surface of theirs. Lengths in
/// the summary, which is left alone in that case, are in the working frame.
std::optional<PointSurface> surfaceOfCleanPoints(const Points& points,
                                                 const OutsideHints& hints,
                                                 ReconstructionSummary& summary);

}  // namespace posture
