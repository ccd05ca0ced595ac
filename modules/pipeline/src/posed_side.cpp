// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "posed_side.h"

#include <posture/mesh/edges.h>

#include <cmath>
#include <utility>

namespace posture {
namespace {

// The k-th eigenvalue is then near 4 pi k.
Pose poseOfUnitArea(const TriangleMesh& mesh) {
  return poseOf(mesh, 1 / std::sqrt(faceAreas(mesh).sum()));
}

}  // namespace

PosedSide::PosedSide(const GivenShape& cleaned)
    : pose(poseOfUnitArea(cleaned.clean.mesh)),
      ordered(inOrder(cleaned.clean, pose)),
      given{cleaned.input, ordered, cleaned.patch_vertices} {}

void PosedSide::scale(double ratio) {
  shape = rescaled(std::move(shape), ratio);
  pose.unit *= ratio;
}

SurfacePlaces PosedSide::coarsePlaces() const {
  return SurfacePlaces(withPieces(shape.coarseSurface().mesh, posed(ordered.pieces, pose)));
}

}  // namespace posture
