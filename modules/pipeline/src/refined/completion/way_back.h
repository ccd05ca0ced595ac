// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/completion/loose_pieces.h"
#include "refined/refinement/full_resolution.h"
#include "refined/work/posed_side.h"
#include "sides/given_shape.h"
#include <vector>

namespace posture {

/// The other direction of a full map.
struct TargetOnSource {
  LaidSide target;
  std::vector<PlacedPiece> pieces;  ///< of it that found a place on the source
};

/// \param scaled  the source's meshes at the scale of the map: `scale`.
/// \param trust  of the map.
TargetOnSource targetOnSource(const PosedSide& source,
                              const RefinedShape& scaled,
                              const PosedSide& target,
                              const FullMap& there,
                              double scale,
                              double trust);

/// How well both ways agree, into the way back; 0 where no vertex has both.
void measureMiss(const GivenShape& source,
                 const TriangleMesh& target,
                 const Correspondence& there,
                 WayBack& back);

}  // namespace posture
