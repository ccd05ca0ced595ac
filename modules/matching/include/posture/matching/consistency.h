// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/matching/candidates.h>

#include <vector>

namespace posture {

/// How well two lengths agree: min(a / b, b / a), in [0, 1]; 0 where one of them is 0 or infinite.
double lengthConsistency(double a, double b);

/// The matrix C of section 4.2: how well the geodesic distance of two matches agrees on both sides.
/// \param source_distances, target_distances  s x s geodesic distances between samples, same unit.
/// \return m x m, symmetric, 1 on the diagonal.
Matrix consistencyMatrix(const std::vector<Match>& matches,
                         const Matrix& source_distances,
                         const Matrix& target_distances);

/// c0 = mu - 3 sigma of section 4.2. Learned by maximum likelihood from the entries off the
/// diagonal of all matrices, mirrored at 1: the mean is then 1 and the variance that of the entries
/// about 1. At least 0, and below 1 even for a perfect isometry.
double consistencyThreshold(const std::vector<Matrix>& matrices);

/// The consistent subset of matches (Leordeanu and Hebert 2005): by the principal eigenvector of
/// M = ((C - c0) / (1 - c0))^2 where C > c0, else 0 (Huang et al. 2008), the strongest match is
/// taken, those inconsistent with it (C <= c0) are dropped, and so on.
/// \return indices into the matches, ascending.
/// \throws std::invalid_argument  a threshold of 1 or more.
std::vector<int> consistencyKernel(const Matrix& consistency, double threshold);

}  // namespace posture
