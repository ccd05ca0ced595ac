// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>
#include <posture/refine/surface.h>

namespace posture {

/// What speaks against a map, each term the mean of both directions and without unit. Only places
/// count whose match is believed: one at the rim of a hole may stand for any place inside it.
struct MapScore {
  /// ARAP energy of each surface bent onto its image, by the share of the surface that has one.
  double bending = 0;
  double curvature = 0;    ///< 1 - correlation of the mean curvatures
  double distortion = 0;   ///< mean relative change of geodesic distances, each at most 1/2
  double return_miss = 0;  ///< how many matches, there and back, do not end where they began
  double let_go = 0;  ///< share of the surface that has no part in the map (letGo()): the larger
  double least_let_go = 0;  ///< that of the other surface: the smaller

  /// Sum of the logarithms: each term counts by its ratio, so none needs a weight. Each is divided
  /// by the share that was not let go of, or letting go would always look better. Lower is better.
  double total() const;

  /// The total for two surfaces of which one may be a piece of the other: what the larger one has
  /// more does not speak against the map.
  double totalOfPiece() const;
};

/// What the total of one map changes by from one bending to the next: less is no gain.
constexpr double SCORE_NOISE = 0.1;

/// \pre  any prefix of each surface's vertices is spread evenly (as reduceMesh() orders them).
MapScore scoreMaps(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps);

/// The same for surfaces that were laid over each other or parts of which were let go of: places
/// without a counterpart do not count either. \param laid  as HowFound has it.
MapScore scoreBent(const SpectralSurface& a,
                   const SpectralSurface& b,
                   const BentPair& pair,
                   bool laid);

/// Whether a map keeps the outside out: over the mapped faces of both surfaces, the mean sign of
/// their normal against that of the surface they come to lie on, weighted by area. 1: every face
/// looks the right way; -1: the body is turned inside out, as a mirrored map does.
double orientation(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps);

}  // namespace posture
