// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Points whose pairwise distances approximate the given ones: leading eigenpairs of the
/// double-centred squared distances (classical scaling, Torgerson 1952).
/// \param distances  s x s, symmetric, zero diagonal, >= 0, finite; s > 3.
/// \return s x 3, centred, axes by decreasing eigenvalue, signs arbitrary; zero along an axis that
///         the distances do not call for.
/// \throws std::invalid_argument  not square or too small.
Points classicalScaling(const Matrix& distances);

/// Minimises the weighted stress sum_{i<j} w_ij (|x_i - x_j| - delta_ij)^2 (Borg and Groenen 1997,
/// p. 146-155; section 4.1) by L-BFGS from `start`.
/// \param weights  s x s, symmetric, >= 0.
Points leastSquaresScaling(const Matrix& distances, const Table& weights, const Points& start);

/// sqrt(sum w (d - delta)^2 / sum w delta^2) over all pairs; 0 for a perfect embedding.
double normalizedStress(const Matrix& distances, const Table& weights, const Points& points);

}  // namespace posture
