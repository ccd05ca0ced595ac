// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined_result.h"

namespace posture {

/// Where all vertices of the source's main surface lie: completeDeformation() from the bent surface
/// and the map's matches. The bent surface itself where the completion refuses the source.
/// \param source  scaled to the target.
/// \return in the frame of the target's working meshes.
Points placesOfWhole(const TriangleMesh& source, const TriangleMesh& target, const FullMap& map);

}  // namespace posture
