// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "refined/completion/target_part.h"
#include <optional>

namespace posture {

/// Whether most of a piece lies on a target so, and looks the same way.
bool liesOn(const TargetPart& target, const Piece& piece, const Eigen::Isometry3d& motion);

/// Where a piece fits a target that is not too far from a motion: drawn there, as iterated closest
/// points (Besl and McKay 1992), from starts that lay places of the one on places of the other.
/// Nothing where it fits nowhere, or elsewhere nearly as well, or is of too few points to tell; nor
/// where its mirror image fits clearly better, as that of a right foot does on a left one; nor
/// where the target goes on beyond what is no rim of the piece, as a leg does beyond a foot that is
/// laid on its middle.
std::optional<Eigen::Isometry3d> drawPiece(const TargetPart& target,
                                           const Piece& piece,
                                           const Eigen::Isometry3d& motion);

}  // namespace posture
