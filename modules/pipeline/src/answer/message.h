// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include <string>

namespace posture {

/// What came out, in a line: how much of the source has a counterpart, or why the data do not
/// decide, and what of the sides was left out that is as large as a body.
std::string messageOf(const RegistrationResult& result);

}  // namespace posture
