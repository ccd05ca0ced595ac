// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Lays the vertices of a deformed surface of which nothing is known as rigidly as possible among
/// those around them, which keep their places (Sorkine and Alexa 2007, with constraints).
/// \param rest    connected, at the scale of `places`.
/// \param places  n x 3, in any frame; those of free vertices do not matter.
/// \param is_free  n, non-zero: nothing is known of this vertex. All of them: `places` is returned.
/// \throws std::invalid_argument  sizes that do not fit.
Points extendDeformation(const TriangleMesh& rest, Points places, const std::vector<char>& is_free);

}  // namespace posture
