// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "given_shape.h"

namespace posture {

/// Places the pieces of the source that are not joined to its main surface. Each makes the rigid
/// motion of the surface next to it, and is then drawn, rigidly, to what of the target the main
/// surface has left free. Its vertices get the nearest places there if most of the piece comes to
/// lie on the target, and none otherwise; where it lies is in `result.deformed` either way.
/// \param result  of the main surfaces: scale, trust, correspondence and deformed are set.
void placeLoosePieces(const GivenShape& source,
                      const GivenShape& target,
                      RegistrationResult& result);

}  // namespace posture
