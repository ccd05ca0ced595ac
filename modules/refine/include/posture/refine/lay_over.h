// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// p -> scale * rotation * p + translation, for points as rows.
struct Similarity {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::RowVector3d translation = Eigen::RowVector3d::Zero();

  Points of(const Points& points) const;
  Points inverseOf(const Points& points) const;
};

/// Places spread evenly over a surface, which may be in pieces. They do not depend on the order of
/// its vertices.
struct SurfacePlaces {
  explicit SurfacePlaces(const TriangleMesh& mesh);

  Points places;
  Points normals;                 ///< unit
  std::vector<char> on_boundary;  ///< of the surface or of a piece
};

/// The different ways to lay surface a over surface b without bending it, at most `most`, by
/// increasing mean distance of places and normals. Iterated closest points (Besl and McKay 1992)
/// from rotations spread evenly over all, both directions, far pairs and rims counting less. What
/// is the same in both poses - a trunk, a piece seen from one side - falls into place however much
/// of the rest is missing.
std::vector<Similarity> layOver(const SurfacePlaces& a, const SurfacePlaces& b, int most);

}  // namespace posture
