// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/work/posed_side.h"

#include <utility>

namespace posture {

PosedSide::PosedSide(const GivenShape& cleaned)
    : pose(poseOf(cleaned.clean.mesh)),
      ordered(inOrder(cleaned.clean, pose)),
      given{cleaned.input, ordered, cleaned.patch_vertices, cleaned.is_patched} {}

void PosedSide::scale(double ratio) {
  shape = rescaled(std::move(shape), ratio);
  pose.unit *= ratio;
}

SurfacePlaces PosedSide::coarsePlaces() const {
  return SurfacePlaces(withPieces(shape.coarse.mesh, posed(ordered.pieces, pose)));
}

}  // namespace posture
