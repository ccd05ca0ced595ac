// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/pipeline/deformed_surface.h>

namespace posture {

DeformedSurface deformedSurface(const Shape& source, const RegistrationResult& result) {
  if (result.source_scan) return {result.source_scan->mesh, result.surface_deformed};
  return joinedSurface(registeredMesh(source, {}, result.source_denoised), result.deformed);
}

}  // namespace posture
