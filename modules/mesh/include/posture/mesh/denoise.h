// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/require_mesh.h>
#include <posture/mesh/seams.h>
#include <posture/mesh/smooth_noise.h>
#include <posture/mesh/spikes.h>

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
inline Denoising denoise(TriangleMesh& mesh) {
  requireMesh(mesh);
  Denoising done;
  done.seam_vertices = closeSeams(mesh);
  done.spikes = setSpikesBack(mesh);
  done.smoothing_rounds = smoothNoise(mesh);
  return done;
}

}  // namespace posture
