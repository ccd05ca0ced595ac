// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>

#include <vector>

namespace posture::synthesis {

/// The halves of the body differ by at most about so much.
constexpr double ASYMMETRY = 0.012;

/// For each place the nearest of the target's places within `reach`, the first of equal ones;
/// places that are not finite have none.
std::vector<VertexPair> nearestPairs(const Points& places, const Points& targets, double reach);

/// Reflected in x = 0.
Points mirrored(Points places);

}  // namespace posture::synthesis
