// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Where a piece of a body may lie on a whole one.
struct PiecePlace {
  std::vector<int> sample;  ///< sample of the piece -> sample of the whole
  double scale = 1;         ///< takes lengths on the piece to lengths on the whole
  double misfit = 0;  ///< mean change of distances over the mean distance, each change at most 1/4
};

/// Distances between samples are all that is looked at, so a mirrored place is as good as the right
/// one. Four samples of the piece, far from each other, go wherever their distances agree, for each
/// scale the piece may have; what they leave undecided of the others' places is then found by all
/// distances in turn. Different places only, by increasing misfit, at most `most`.
/// \param piece, whole  s x s and t x t, geodesic distances between samples of which any prefix is
///        spread evenly; each shape in square roots of its area.
/// \throws std::invalid_argument  fewer than four samples, a distance that is not finite, a piece
///         all at one place.
std::vector<PiecePlace> placePiece(const Matrix& piece, const Matrix& whole, int most);

}  // namespace posture
