// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/side_surface.h"

#include <posture/core/error.h>

namespace posture {

SideSurface surfaceOf(const std::string& side, const Shape& shape, SurfaceMethod method) {
  if (shape.faces.rows() > 0) return SideSurface({shape.cloud.points, shape.faces});
  return naming(side, [&] {
    SideSurface surface;
    surface.scan = reconstruct(shape.cloud, {method});
    surface.mesh = surface.scan->mesh;
    return surface;
  });
}

}  // namespace posture
