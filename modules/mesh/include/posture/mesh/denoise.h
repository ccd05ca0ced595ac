// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// What denoise() did.
struct Denoising {
  int seam_vertices = 0;     ///< as closeSeams() returns
  int spikes = 0;            ///< as setSpikesBack() returns
  int smoothing_rounds = 0;  ///< as smoothNoise() returns

  bool movedAny() const { return seam_vertices > 0 || spikes > 0 || smoothing_rounds > 0; }
};

/// What a mesh goes through before anything else is done with its shape.
/// \throws std::invalid_argument  as requireMesh().
Denoising denoise(TriangleMesh& mesh);

}  // namespace posture
