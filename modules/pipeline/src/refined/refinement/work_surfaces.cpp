// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refinement/work_surfaces.h"

#include <posture/core/parallel.h>

#include <algorithm>

namespace posture {

WorkSurfaces::WorkSurfaces(const RefinedShape& source,
                           const RefinedShape& target,
                           const std::vector<const Finalist*>& finalists) {
  for (const Finalist* finalist : finalists)
    if (std::find(scales_.begin(), scales_.end(), finalist->scale) == scales_.end())
      scales_.push_back(finalist->scale);
  surfaces_.resize(1 + scales_.size());
  parallelFor(static_cast<int>(surfaces_.size()), [&](int i) {
    const RefinedShape shape = i == 0 ? target : rescaled(source, scales_[i - 1]);
    surfaces_[i] = std::make_unique<const SpectralSurface>(shape.workSurface());
  });
}

const SpectralSurface& WorkSurfaces::source(double scale) const {
  const auto found = std::find(scales_.begin(), scales_.end(), scale);
  return *surfaces_[1 + (found - scales_.begin())];
}

}  // namespace posture
