// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>

namespace posture {

/// Bends two surfaces onto each other that have been laid over each other: from stiff to soft,
/// each vertex drawn to what is nearest in both poses, places and normals; what lies far from
/// everything, as where the other surface is missing, pulls little.
/// \param laid  a's vertices over b.
/// \param back  b's vertices over a.
BentPair conform(const BendableSurface& a,
                 const BendableSurface& b,
                 const Points& laid,
                 const Points& back);

}  // namespace posture
