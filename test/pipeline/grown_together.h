// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/edge_paths.h>

#include "support/bodies.h"
#include "support/shapes.h"

namespace posture::test {

enum class Contact { TUBE, VERTEX };

/// The body with two places grown together that are near in space and far along the surface.
struct Fused {
  TriangleMesh mesh;
  int a = 0, b = 0;
};

inline Fused grownTogether(const ArticulatedBody& body, Contact contact = Contact::TUBE) {
  Fused result;
  double best = 0;
  const EdgePaths paths(body.mesh);
  for (int a = 0; a < body.mesh.vertices.rows(); a += 7) {
    const Vector along = paths.lengths({a});
    for (int b = 0; b < body.mesh.vertices.rows(); ++b) {
      const double straight = (body.mesh.vertices.row(a) - body.mesh.vertices.row(b)).norm();
      const double gain = along[b] / (straight + 0.02);
      if (along[b] > 0.5 && gain > best) {
        best = gain;
        result.a = a;
        result.b = b;
      }
    }
  }
  if (contact == Contact::TUBE) {
    result.mesh = test::fused(body.mesh, result.a, result.b);
  } else {
    result.mesh = body.mesh;
    for (int& corner : result.mesh.faces.reshaped())
      if (corner == result.b) corner = result.a;
  }
  return result;
}

}  // namespace posture::test
