// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/shapes.h"

namespace posture::test {

/// A body on a floor of 30 x 30 quads, of which every vertex comes after the body's.
inline TriangleMesh onFloor(const TriangleMesh& body, double size) {
  TriangleMesh floor = test::grid(30, 30, size, size);
  floor.vertices.leftCols(2).array() -= 0.5 * size;
  floor.vertices.col(2).setConstant(body.vertices.col(2).minCoeff());
  return test::joined(body, floor);
}

}  // namespace posture::test
