// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/surface.h>

#include <vector>

namespace posture {

/// Vertices of two surfaces at the same place of the body.
struct PlacePair {
  int a, b;
};

/// The end of a limb as a rigid body, where it is one that fits in one way only: a head with its
/// ears and nose, not a paw, which fits turned nearly as well.
struct RigidEnd {
  std::vector<int> vertices;      ///< of a
  std::vector<PlacePair> places;  ///< spread over what of it has a partner
  bool turned = false;            ///< by more than 30 degrees against how the map lays it
};

/// Lays the ends of limbs of one surface on those of another, each by itself, from all sides and
/// as the map lays it (closest points, Besl and McKay 1992; trimmed, Chetverikov et al. 2002). Both
/// surfaces in their own pose: where a body stretches, its ends do not. Ends that fit in several
/// ways are left out.
/// \param tips  vertices of a, ends of limbs. What lies in the end of one before is not looked at
///              again.
/// \param maps  says which end of b belongs to which of a.
/// \pre  both in one unit, about the square roots of their areas, and the first vertices of each
///       spread evenly, as reduceMesh() leaves them.
std::vector<RigidEnd> rigidEnds(const SpectralSurface& a,
                                const SpectralSurface& b,
                                const std::vector<int>& tips,
                                const VertexMaps& maps);

}  // namespace posture
