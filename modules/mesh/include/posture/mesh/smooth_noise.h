// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Smooths the vertices of a noisy mesh (Taubin 1995, which does not shrink it), rims along
/// themselves; vertices at the same place move together. Noisy is a mesh whose vertices smoothing
/// moves along the normal by 0.16 edges and more from where it moves their neighbours, in the
/// median: those of bodies come to 0.07, coarse ones of 250 vertices to 0.12, noise of 0.3 edges to
/// 0.22; and in the median by 0.11 from the second likest of these: noise leaves each vertex alone,
/// but the sharp edges of what was built or turned, which smoothing would round off, go on through
/// two at least. Any other mesh stays as it is.
/// \return  how many rounds of smoothing that took; 0: there was next to no noise.
int smoothNoise(TriangleMesh& mesh);

}  // namespace posture
