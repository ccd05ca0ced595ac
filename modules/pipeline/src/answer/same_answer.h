// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include <vector>

namespace posture {

/// How two answers lie to each other, where both map something.
struct Overlap {
  int both = 0, either = 0, fewer = 0;  ///< vertices that both, either, and the one with fewer map
  double gap = 0;  ///< mean distance between where both take what both map, over the size
};

/// \param size  of the target: square root of its area.
Overlap overlapOf(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target,
                  double size);

/// How far two answers lie apart, over the size; 1 where they hardly map the same.
double gapOf(const Overlap& overlap);

/// Whether an answer is another one. One that maps less, and agrees there, is not.
bool leadsElsewhere(const Overlap& overlap);

/// Whether two attempts at one pair lead to the same places: what both map is at least half of what
/// either does, and lies less than a tenth of the size apart in the mean.
bool isSameAnswer(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target);

/// Whether `more` maps at least as much as `known`, but for crumbs, and leads to the same places
/// where both map.
bool goesOn(const RegistrationResult& known,
            const RegistrationResult& more,
            const TriangleMesh& target);

/// Whether two maps of one pair lead to the same places everywhere, but for crumbs;
/// not if they share less than half.
/// \param size  of the target: square root of its area.
bool agreeEverywhere(const std::vector<SurfacePoint>& x,
                     const std::vector<SurfacePoint>& y,
                     const TriangleMesh& target,
                     double size);

}  // namespace posture
