// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include <functional>

namespace posture {

/// A registration as far as it takes to compare it with others: most of those made are not taken.
struct Attempt {
  /// Score, trust and the figures of its alternatives are as they will be; the map, of the main
  /// surface alone, is good to the edges of the work meshes, and the source is not deformed.
  RegistrationResult found;
  std::function<RegistrationResult()> finish;  ///< empty: `found` is all there is
};

/// Whether an answer was found with a part of a side alone.
bool isOfPart(const RegistrationResult& result);

/// \throws TornSurface  a surface cannot be bent
RegistrationResult finished(Attempt attempt);

/// The attempt with what `change` makes of its result, before and after it is finished.
Attempt withChange(Attempt attempt, const std::function<void(RegistrationResult&)>& change);

}  // namespace posture
