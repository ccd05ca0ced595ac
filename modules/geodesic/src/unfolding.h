// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// A triangle laid into the plane: `left` at 0, `right` at (base, 0), `apex` at (x, y), y > 0. Its
/// corner at `apex` is the one the front arrives at.
struct UnfoldedTriangle {
  int apex, left, right;
  double base, x, y;
};

/// Every corner of every face, and for each obtuse corner the two narrower triangles that splitting
/// it gives: faces beyond its opposite edge are unfolded into its plane until one of their vertices
/// lies where the line to it cuts the corner into two acute ones (Kimmel and Sethian 1998).
/// Faces without area have only their sides: y is then tiny but positive.
std::vector<UnfoldedTriangle> unfoldedTriangles(const TriangleMesh& mesh);

}  // namespace posture
