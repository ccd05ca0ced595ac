// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// \throws std::invalid_argument  a corner of a face is no vertex, or a vertex is not finite.
void requireMesh(const TriangleMesh& mesh);

}  // namespace posture
