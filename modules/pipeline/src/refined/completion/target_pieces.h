// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/completion/loose_pieces.h"
#include "sides/given_shape.h"
#include <vector>

namespace posture {

/// Vertices of the source's main surface that lie on pieces which are not joined to the target's.
struct OnPieces {
  std::vector<int> vertex;              ///< of the main surface
  std::vector<SurfacePoint> on_target;  ///< in the target as it was given
  std::vector<double> fit;              ///< in (0, 1]; 1: exactly there
  Points places;                        ///< where the pieces' motions take them, in its frame
  /// Those beside them on which neither a piece nor the target's main surface lies: they belong
  /// into the gap, and have been squeezed onto its rim.
  std::vector<int> in_gap;
};

/// Those on which a piece of the target lies, placed on the source, and the target's main surface
/// does not.
/// \param back  the target laid onto the source.
/// \param placed  the target's pieces that found a place there.
OnPieces onPieces(const GivenShape& source,
                  const GivenShape& target,
                  const LaidSide& back,
                  const std::vector<PlacedPiece>& placed);

/// Gives the one their places, and takes those of the others away.
void addMatches(const GivenShape& source, const OnPieces& on_pieces, LaidSide& laid);

}  // namespace posture
