// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>

namespace posture {

/// Place and normal on the surface itself and where it is bent to, so that a distance between two
/// columns sees both directions. Twelve numbers a vertex.
using PoseFeatures = Eigen::Matrix<float, 12, Eigen::Dynamic>;

struct PoseFeaturePair {
  PoseFeatures a, b;
};

/// \param softness  the more of it, the less normals count.
PoseFeaturePair poseFeatures(const BendableSurface& a,
                             const BendableSurface& b,
                             double softness,
                             const BentPair& pair);

}  // namespace posture
