// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sides/given_shape.h"

namespace posture {

/// Notes for each side how large its largest part is that the map leaves out: another body in the
/// scan, or a piece that found no place.
void noteLeftOutParts(const GivenShape& source,
                      const GivenShape& target,
                      RegistrationResult& result);

}  // namespace posture
