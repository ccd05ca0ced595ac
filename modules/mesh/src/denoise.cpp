// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/denoise.h>
#include <posture/mesh/require_mesh.h>
#include <posture/mesh/seams.h>
#include <posture/mesh/smooth_noise.h>
#include <posture/mesh/spikes.h>

namespace posture {

Denoising denoise(TriangleMesh& mesh) {
  requireMesh(mesh);
  Denoising done;
  done.seam_vertices = closeSeams(mesh);
  done.spikes = setSpikesBack(mesh);
  done.smoothing_rounds = smoothNoise(mesh);
  return done;
}

}  // namespace posture
