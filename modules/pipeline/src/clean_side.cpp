// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean_side.h"

#include <posture/core/error.h>
#include <posture/mesh/denoise.h>

namespace posture {

CleanMesh cleanSide(const std::string& side, SideSurface& surface) {
  try {
    if (!surface.scan) surface.denoising = denoise(surface.mesh);
    return cleanMesh(surface.mesh);
  } catch (const InputError& error) {
    throw InputError(side + " " + error.what());
  }
}

std::vector<StagePicture> cleaningPictures(const CleanMesh& source, const CleanMesh& target) {
  return {{"source-main-surface", source.mesh, source.mesh.vertices, {}},
          {"target-main-surface", target.mesh, target.mesh.vertices, {}}};
}

}  // namespace posture
