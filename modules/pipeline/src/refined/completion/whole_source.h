// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/completion/target_pieces.h"
#include "refined/refinement/full_resolution.h"
#include "refined/work/posed_side.h"
#include "sides/given_shape.h"

namespace posture {

/// Where all vertices of the source's main surface lie: completeDeformation() from the bent surface
/// and the map's matches; what has none, or one on a patch, lies as the surface around it goes. The
/// bent surface itself where the completion refuses the source.
/// \param scaled  the source at the scale of the map.
/// \param on_pieces  vertices that lie on pieces of the target.
/// \return in the frame of the target's working meshes.
Points placesOfWhole(const PosedSide& source,
                     const RefinedShape& scaled,
                     const PosedSide& target,
                     const FullMap& map,
                     const OnPieces& on_pieces);

/// The places of the source's vertices, those without a counterpart laid as rigidly as possible
/// among the others. \param result  finished.
Points restLaid(const GivenShape& source, const RegistrationResult& result);

}  // namespace posture
