// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "sides/leave_out_background.h"
#include <optional>
#include <string>
#include <utility>

namespace posture {

/// One side as a surface: the mesh as it was given, or one laid through the points.
struct SideSurface {
  SideSurface() = default;
  explicit SideSurface(TriangleMesh of) : mesh(std::move(of)) {}

  TriangleMesh mesh;
  std::optional<ScanSurface> scan;  ///< of a point cloud; its mesh is in `mesh`
  Denoising denoising;              ///< set by cleanSides()
  Background background;            ///< left out; set by cleanSides()
};

/// \throws InputError  no surface can be laid through the points; names the side.
SideSurface surfaceOf(const std::string& side, const Shape& shape, SurfaceMethod method);

}  // namespace posture
