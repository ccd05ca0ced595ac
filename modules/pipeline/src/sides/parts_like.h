// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/clean_mesh.h>

#include "sides/given_shape.h"
#include <vector>

namespace posture {

/// Whether more than eyes and crumbs lies off a main surface in pieces: a finger or a tail, and
/// what is one with the main surface on the other side would be squeezed onto what is next to it.
bool isInPieces(const CleanMesh& surface);

/// Whether something was cut off a surface, or not seen of it: its rims, but those a limb does not
/// fit through, are longer than that of holes no matter what lies beyond them, or it is in pieces.
bool mayBePiece(const CleanMesh& surface);

/// The parts of a whole, cut out of it, that a piece of another pose may be; the likeliest first,
/// at most `most`. Parts that are nearly all of the whole are left out: it can be compared as it
/// is.
std::vector<CleanMesh> partsLike(const CleanMesh& piece, const GivenShape& whole, int most);

}  // namespace posture
