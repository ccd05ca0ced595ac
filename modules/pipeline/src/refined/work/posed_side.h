// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/lay_over.h>

#include "refined/work/refined_shape.h"
#include "sides/given_shape.h"
#include "sides/pose.h"

namespace posture {

/// A side in a frame, a unit and an order of its own: the answer does not depend on those it came
/// in. With the meshes it is worked on, which are in that frame.
struct PosedSide {
  explicit PosedSide(const GivenShape& cleaned);
  PosedSide(const PosedSide&) = delete;
  PosedSide& operator=(const PosedSide&) = delete;

  Pose pose;  ///< lengths in square roots of the area, until they are scaled to the other side
  CleanMesh ordered;
  GivenShape given;  ///< as it came, with `ordered` for its main surface
  RefinedShape shape;

  /// Multiplies all lengths. \pre `shape` is set.
  void scale(double ratio);

  /// The coarse surface with the pieces that are not part of it.
  SurfacePlaces coarsePlaces() const;
};

}  // namespace posture
