// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace posture {

/// A place whose coordinates are whole numbers of less than 2^52: predicates on them are exact.
using LatticePoint = std::array<double, 3>;

/// Sign of det(b - a, c - a, d - a).
int orientation(const LatticePoint& a,
                const LatticePoint& b,
                const LatticePoint& c,
                const LatticePoint& d);

/// Whether `e` lies within the sphere through a, b, c, d, of positive orientation. Of cospherical
/// points the answers are those of one triangulation, without flat tetrahedra: Devillers and
/// Teillaud, Perturbations and vertex removal in a 3D Delaunay triangulation (2003).
/// \pre  different places.
bool isInSphere(const LatticePoint& a,
                const LatticePoint& b,
                const LatticePoint& c,
                const LatticePoint& d,
                const LatticePoint& e);

}  // namespace posture
