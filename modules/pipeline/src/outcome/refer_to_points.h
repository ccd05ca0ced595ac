// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "sides/side_surface.h"

namespace posture {

/// Rewrites a result between the two surfaces in terms of the shapes as given: one row for each
/// point of a source cloud, and `vertex` of each place the nearest point of a target cloud. Faces
/// stay those of the surfaces, which the result then holds.
void referToPoints(const Shape& source,
                   const Shape& target,
                   SideSurface source_surface,
                   SideSurface target_surface,
                   RegistrationResult& result);

}  // namespace posture
