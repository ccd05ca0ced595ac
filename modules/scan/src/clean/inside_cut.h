// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clean/circumspheres.h"
#include <vector>

namespace posture {

/// Non-zero for the tetrahedra inside a body, by a minimum cut between inside and outside (Labatut,
/// Pons and Keriven 2009, with the normals of the points in the place of lines of sight). Each
/// point votes for the tetrahedra before and behind it; the faces between inside and outside cost
/// the more the larger they are against the empty spheres on either side.
std::vector<char> insideByCut(const Points& points,
                              const Stars& stars,
                              const Circumspheres& spheres,
                              const Points& normals);

}  // namespace posture
