// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/finalists/finalists.h"
#include "refined/work/refined_shape.h"
#include <vector>

namespace posture {

/// Maps between the samples from the first different finalists that turn an end of a limb which
/// fits as a rigid body in one way only (rigidEnds()): tips of limbs go where the finalist takes
/// them, such ends where they fit. None for finalists that turn no end.
/// \param source, target  the coarse surfaces.
/// \param distinct  of the finalists, those that are different.
std::vector<SampleMap> endMaps(const RefinedShape& source_shape,
                               const RefinedShape& target_shape,
                               const SpectralSurface& source,
                               const SpectralSurface& target,
                               const std::vector<Finalist>& finalists,
                               const std::vector<int>& distinct);

}  // namespace posture
