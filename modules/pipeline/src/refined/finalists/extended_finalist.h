// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "refined/finalists/finalists.h"
#include "refined/finalists/find_finalists.h"

namespace posture {

/// An answer, in the numbering of both inputs, as a map between the coarse surfaces, extended
/// (extendMap()) over what of both then lies on each other.
/// \param known  finished: the source is deformed.
/// \throws NoWayOn  it maps nothing of the coarse surfaces, or turns one inside out;
/// TornSurface
Finalist extendedFinalist(const CoarseSides& sides, const RegistrationResult& known);

}  // namespace posture
