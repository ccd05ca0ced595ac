// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Axes of a body's own: those of the second moments of points about the origin, in the order of
/// these, pointing to where the body reaches farther (third moments). They turn with the points
/// unless second moments are equal or third ones vanish.
/// \param weights  n, not negative.
/// \return a rotation; its columns are the axes.
Eigen::Matrix3d momentAxes(const Points& points, const Vector& weights);

}  // namespace posture
