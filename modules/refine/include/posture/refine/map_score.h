// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/surface.h>

namespace posture {

/// What speaks against a map, each term the mean of both directions and without unit.
struct MapScore {
  double bending = 0;        ///< ARAP energy of each surface bent onto its image
  double curvature = 0;      ///< 1 - correlation of the mean curvatures
  double orthogonality = 0;  ///< |C'C - I|^2 / k: areas that the functional map C does not keep
  double commutator = 0;     ///< |Lambda_A C - C Lambda_B|^2 / |Lambda_A C|^2: isometry

  /// Sum of the logarithms: each term counts by its ratio, so none needs a weight. Lower is better.
  double total() const;
};

MapScore scoreMaps(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps);

/// Whether a map keeps the outside out: over the mapped faces of both surfaces, the mean sign of
/// their normal against that of the surface they come to lie on, weighted by area. 1: every face
/// looks the right way; -1: the body is turned inside out, as a mirrored map does.
double orientation(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps);

}  // namespace posture
