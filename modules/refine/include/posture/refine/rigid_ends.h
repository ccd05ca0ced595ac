// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/surface.h>

#include <Eigen/Geometry>

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
  std::vector<int> of_b;          ///< vertices of the end of b that the map takes it to
  std::vector<PlacePair> places;  ///< spread over what of it has a partner
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  ///< lays it on that of b
  bool turned = false;  ///< by more than 30 degrees against how the map lays it
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

/// How well the end of a limb fits as a rigid body where a map takes it, however it is turned.
/// Infinite where one of the two ends does not tell: it has too few vertices, or is not all there.
struct EndFit {
  int tip;
  double misfit;     ///< mean squared distance, normals included, the largest fifth left out
  double next;       ///< that of the next best way, turned by more than 30 degrees against it
  double by_chance;  ///< twice the misfit that comes of where vertices happen to lie

  /// Whether there is but one way: the end is no paw.
  bool fitsInOneWay() const;
};

/// The same ends as for rigidEnds(), those that fit in several ways too. \pre  as there.
std::vector<EndFit> fitEnds(const SpectralSurface& a,
                            const SpectralSurface& b,
                            const std::vector<int>& tips,
                            const VertexMaps& maps);

/// Ends of limbs that a map takes to their like, and to the mirror images of these.
struct HandVote {
  int for_it = 0, against_it = 0;
};

/// Whether a map takes right hands and feet to right ones, not to left ones. An end tells where it,
/// or its mirror image, fits clearly better where the map takes it, and in one way only: most
/// heads, which are their own mirror images, and paws do not, nor do ends of few vertices, or that
/// are not all there. What a map that is half-turned, front on back and left on right, cannot hide:
/// it keeps the outside out, and hardly bends a body more than the right one.
///
/// \param tips_a, tips_b  ends of limbs of either; what was looked at from a is not from b again.
/// \pre  as for rigidEnds().
HandVote handVote(const SpectralSurface& a,
                  const SpectralSurface& b,
                  const std::vector<int>& tips_a,
                  const std::vector<int>& tips_b,
                  const VertexMaps& maps);

/// How much worse ends fit under each of several maps: summed over the ends that fit in one way
/// only under one of the maps, the logarithm of the misfit over that of the map under which they do
/// so best, each between 0 and ln 2. A left hand does not fit a right one. What does not tell under
/// one of the maps, or was not looked at, does not count.
/// \param fits  of each map, by fitEnds() for the same tips.
std::vector<double> endDisagreements(const std::vector<std::vector<EndFit>>& fits);

}  // namespace posture
