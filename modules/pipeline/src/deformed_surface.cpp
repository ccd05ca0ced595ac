// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/denoise.h>
#include <posture/pipeline/deformed_surface.h>

namespace posture {

DeformedSurface deformedSurface(const Shape& source, const RegistrationResult& result) {
  if (result.source_scan) return {result.source_scan->mesh, result.surface_deformed};
  TriangleMesh rest{source.cloud.points, source.faces};
  denoise(rest);
  return joinedSurface(rest, result.deformed);
}

}  // namespace posture
