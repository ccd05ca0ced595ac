// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

namespace posture {

/// An answer that another attempt at the pair has found. Where it is trusted and the best finalist
/// leads everywhere to where it does, parts are neither let go of nor grown anew, and tips sought
/// only where the best finalist does not convince.
struct KnownAnswer {
  const RegistrationResult* result = nullptr;  ///< in the numbering of both inputs; null: none
  bool may_stop = false;  ///< whether to end as soon as it is confirmed and stands (knownStands())
};

}  // namespace posture
