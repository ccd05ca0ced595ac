// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "refined/completion/laid_side.h"
#include "refined/completion/target_part.h"
#include "sides/given_shape.h"
#include <vector>

namespace posture {

/// What pieces are laid on.
PieceTarget pieceTarget(const GivenShape& target);

/// Near which places a side's main surface lies where it was taken to, as far as it has
/// counterparts.
/// \param reach  how near, in the unit of the places.
std::vector<char> coveredBy(const GivenShape& shape,
                            const LaidSide& laid,
                            const Points& places,
                            double reach);

/// Whether there is any surface off the main one.
bool hasLoosePieces(const GivenShape& shape);

/// A piece that found a place on the target.
struct PlacedPiece {
  std::vector<int> vertices;  ///< of the source
  Eigen::Isometry3d motion;   ///< of the piece at the scale of the target
};

/// Places the pieces of the source that are not joined to its main surface. Each makes the rigid
/// motion of the surface next to it, and is then drawn, rigidly, to what of the target the main
/// surface has left free. Its vertices get the nearest places there if most of the piece comes to
/// lie on the target, and none otherwise; it is laid either way.
/// \param laid  the source, so far without them.
/// \return  the pieces that lie on the target.
std::vector<PlacedPiece> placeLoosePieces(const GivenShape& source,
                                          const GivenShape& target,
                                          LaidSide& laid);

}  // namespace posture
