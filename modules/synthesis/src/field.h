// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "skeleton.h"
#include <vector>

namespace posture::synthesis {

/// The flesh around the bones: < 0 inside, 0 on the skin, about the distance near it. A smooth
/// union of the parts, bent slightly out of symmetry, as every body is.
class FleshField {
 public:
  explicit FleshField(const BodyShape& shape);

  double value(const Vec3& p) const;
  Vec3 gradient(const Vec3& p) const;
  Vec3 project(Vec3 p) const;  ///< to the skin, along the gradient
  /// The edge length to mesh the skin with here: `edge` times the detail of the parts, less where
  /// they are too thin for that.
  double edgeLength(const Vec3& p, double edge) const;

  /// Distance to one part alone, before the union.
  double partDistance(int part, const Vec3& p) const;
  int numParts() const { return static_cast<int>(parts_.size()); }

  Vec3 lowerCorner() const { return lower_; }
  Vec3 upperCorner() const { return upper_; }

 private:
  struct Flattened {
    Part part;
    Eigen::Matrix3d stretch;  ///< into the space where the cross-section is round
    Vec3 a, ab;               ///< there
    double ab_sq;
    Vec3 center;
    double reach;  ///< the part lies in the ball (center, reach)
  };
  struct Nearest {
    double distance;
    double radius;  ///< of the part, across, where it is nearest
  };
  Nearest nearest(int part, const Vec3& straight) const;  ///< of a place before the bending

  std::vector<Flattened> parts_;
  Vec3 lower_, upper_;
};

}  // namespace posture::synthesis
