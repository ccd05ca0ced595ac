// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Lays the vertices of a deformed surface of which nothing is known as rigidly as possible among
/// those around them, which keep their places (Sorkine and Alexa 2007, with constraints).
/// Each region of free vertices is laid by itself. One with no face of known vertices within two
/// edges keeps the places given, and so does one that is too torn to be laid.
/// \param rest    at the scale of `places`.
/// \param places  n x 3, in any frame.
/// \param is_free  n, non-zero: nothing is known of this vertex.
/// \throws std::invalid_argument  sizes that do not fit.
Points extendDeformation(const TriangleMesh& rest, Points places, const std::vector<char>& is_free);

}  // namespace posture
