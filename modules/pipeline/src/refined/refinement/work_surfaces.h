// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/finalists/finalists.h"
#include "refined/work/refined_shape.h"
#include <memory>
#include <vector>

namespace posture {

/// The work meshes of the target, and of the source at each finalist's scale, most of which are 1.
class WorkSurfaces {
 public:
  WorkSurfaces(const RefinedShape& source,
               const RefinedShape& target,
               const std::vector<const Finalist*>& finalists);

  const SpectralSurface& target() const { return *surfaces_[0]; }

  /// \param scale  of one of the finalists.
  const SpectralSurface& source(double scale) const;

 private:
  std::vector<double> scales_;
  std::vector<std::unique_ptr<const SpectralSurface>> surfaces_;  // the target's first
};

}  // namespace posture
