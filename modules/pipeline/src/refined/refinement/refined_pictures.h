// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/observer.h>

#include "refined/finalists/finalists.h"
#include "refined/refinement/refined_maps.h"
#include "refined/work/refined_shape.h"

namespace posture {

std::vector<StagePicture> samplePictures(const RefinedShape& source, const RefinedShape& target);

/// Each of the distinct finalists as the target's coarse mesh in the source's colours.
std::vector<StagePicture> finalistPictures(const SpectralSurface& source,
                                           const SpectralSurface& target,
                                           const std::vector<Finalist>& finalists,
                                           const std::vector<int>& distinct);

/// The work meshes bent onto each other.
std::vector<StagePicture> refinedPictures(const RefinedShape& source,
                                          const RefinedShape& target,
                                          const RefinedMap& map);

}  // namespace posture
