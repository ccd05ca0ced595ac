// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <array>
#include <optional>
#include <vector>

namespace posture {

/// Delaunay tetrahedra of points in space. Beyond each face of the convex hull lies one more that
/// has the point at infinity, of number n, for a corner. For corners a, b, c, d of a finite one
/// det(b - a, c - a, d - a) > 0.
struct Tetrahedra {
  std::vector<std::array<int, 4>> corners;
  std::vector<std::array<int, 4>> beyond;  ///< the neighbour across the face opposite each corner

  int size() const { return static_cast<int>(corners.size()); }

  /// The face opposite corner k, counter-clockwise seen from outside the tetrahedron.
  std::array<int, 3> face(int t, int k) const;

  /// The corner opposite the same face in the neighbour across the face opposite corner k.
  int mirror(int t, int k) const;
};

/// The tetrahedra at each point: those of i are tetrahedra[first[i]] .. tetrahedra[first[i + 1] -
/// 1].
struct Stars {
  std::vector<int> first;
  std::vector<int> tetrahedra;
};

Stars starsOf(const Tetrahedra& tetrahedra, int point_count);

/// By inserting one point after the other (Bowyer 1981, Watson 1981), with exact predicates.
/// Coordinates are rounded to 2^-32, or to 2^-51 of the extent where that is coarser; of points
/// that then coincide one is a corner. Any position is allowed, cospherical ones included. Nothing
/// when all are in a plane. \pre  some points, near ones near in order.
std::optional<Tetrahedra> delaunay(const Points& points);

}  // namespace posture
