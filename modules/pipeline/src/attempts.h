// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include <vector>

namespace posture {

/// Whether two attempts at one pair lead to the same places, as far as samples tell.
bool isSameAnswer(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target);

/// One answer found twice: the map found with closed holes, which drifts less, with the verdict
/// that trusts it more. Patches differ from pose to pose and blur what tells answers apart; long
/// rims, as between few views of a body, hide that two shapes are one. Where patches led the map
/// astray, so that it scores far worse, all stays as found without.
RegistrationResult withPatchedMap(RegistrationResult as_given, RegistrationResult patched);

/// Of several attempts at one pair, on different parts of it, the one that scores best, the first
/// if none is better by more than scores vary. The best of the others that leads elsewhere is named
/// among its alternatives. \pre  at least one.
RegistrationResult bestAttempt(std::vector<RegistrationResult> attempts,
                               const TriangleMesh& target,
                               const RegistrationOptions& options);

}  // namespace posture
