// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "skeleton.h"
#include <vector>

namespace posture::synthesis {

/// One angle triple a bone: pose 0 all zero, then the table's, any other number drawn at random
/// within the joints' limits so that limbs stay clear of each other and of the trunk.
std::vector<JointAngles> jointAngles(const BodyShape& shape,
                                     const std::vector<PoseTable>& table,
                                     int pose);

}  // namespace posture::synthesis
