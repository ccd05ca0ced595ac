// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/deformation/apply_deformation.h>
#include <posture/pipeline/register_shapes.h>

namespace posture {

/// The surface that was registered, as it was laid through points or denoised, and where it came
/// to: with it applyDeformation() takes other points along.
/// \param source  as registerShapes() got it.
/// \throws InputError  its faces are no surface.
DeformedSurface deformedSurface(const Shape& source, const RegistrationResult& result);

}  // namespace posture
