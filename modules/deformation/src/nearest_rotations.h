// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "arap_steps.h"
#include <vector>

namespace posture {

/// Replaces each matrix M by the rotation R with the largest trace of R' M: by one of those, where
/// several are as good; by no numbers, where M is not finite.
void toNearestRotations(std::vector<WideMatrix>& matrices);

}  // namespace posture
