// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <array>
#include <vector>

namespace posture {

/// Cuts a polygon into triangles by its ears (Meisters 1975), as seen along its mean normal: none
/// lies outside of one that does not cross itself there, concave or not. Ears are taken evenly
/// around it, so that no corner of a large one gets many triangles. A convex polygon of four
/// corners is cut as a fan about the first.
/// \param corners  n x 3, n >= 3, in order.
/// \return  n - 2 triangles that run as the polygon does, of numbers of corners, the
///         lowest first.
std::vector<std::array<int, 3>> cutPolygon(const Points& corners);

}  // namespace posture
