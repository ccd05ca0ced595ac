// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// How a deformed source sits on its target: what can be said where no truth is known.
struct SurfaceFit {
  double median_distance = 0;  ///< to the nearest target vertex, in mean target edge lengths
  double percentile_95_distance = 0;
  double mean_stretch =
      0;  ///< |log(deformed / source edge length)|, the source scaled to the target
  double percentile_95_stretch = 0;
};

/// \param deformed  n x 3: the source's vertices moved onto the target.
/// \param scale  a source length times this is a target length.
/// \throws std::invalid_argument  deformed does not fit the source; a mesh without faces.
SurfaceFit measureFit(const TriangleMesh& source,
                      const Points& deformed,
                      double scale,
                      const TriangleMesh& target);

}  // namespace posture
