// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

namespace posture {

/// Sets status and message from the chosen hypothesis: two bodies are called the same one when
/// distances on them agree under it.
void giveVerdict(RegistrationResult& result);

}  // namespace posture
