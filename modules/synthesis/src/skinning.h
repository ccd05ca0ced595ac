// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include "field.h"
#include <vector>

namespace posture::synthesis {

/// How much each bone moves each place on the skin: n x bones, rows sum to 1. Depends on the place
/// alone, not on the mesh; exactly one bone away from the joints.
Matrix skinWeights(const BodyShape& shape, const FleshField& field, const Points& rest);

/// Bones' rigid motions rest -> pose for one angle triple a bone.
std::vector<Eigen::Isometry3d> boneMotions(const BodyShape& shape,
                                           const std::vector<JointAngles>& angles);

/// Blends motions as dual quaternions, which keeps the girth of a limb where it bends or twists.
/// \see Kavan, Collins, Zara, O'Sullivan, Skinning with Dual Quaternions, I3D 2007.
Points skin(const Points& rest,
            const Matrix& weights,
            const std::vector<Eigen::Isometry3d>& motions);

}  // namespace posture::synthesis
