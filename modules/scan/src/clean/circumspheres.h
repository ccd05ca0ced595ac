// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clean/delaunay.h"
#include <vector>

namespace posture {

/// The spheres through the corners of Delaunay tetrahedra, which have no point in them. Those of
/// infinite tetrahedra are half-spaces beyond the hull.
class Circumspheres {
 public:
  /// \pre  both outlive this.
  Circumspheres(const Points& points, const Tetrahedra& tetrahedra);

  const Tetrahedra& tetrahedra() const { return tetrahedra_; }

  bool isInfinite(int t) const { return infinite_[t] >= 0; }

  /// From a corner to the centre; of an infinite tetrahedron the unit normal away from the hull.
  Eigen::RowVector3d direction(int corner, int t) const;

  /// Infinite for an infinite tetrahedron.
  double radius(int t) const { return radii_[t]; }

  /// Cosine of the angle between the spheres of neighbours: 1 where they are the same, near -1
  /// where they merely touch, as those on either side of a well sampled surface do.
  double overlap(int s, int t) const;

  /// Cosine of the angle between a sphere and the face opposite corner k: 1 for a face small
  /// against the sphere, whose centre lies on the side of the tetrahedron; negative when beyond the
  /// face.
  double faceCosine(int t, int k) const;

 private:
  const Points& points_;
  const Tetrahedra& tetrahedra_;
  std::vector<int> infinite_;  ///< the corner at infinity, or -1
  Points centers_;             ///< of infinite ones: direction()
  std::vector<double> radii_;
};

}  // namespace posture
