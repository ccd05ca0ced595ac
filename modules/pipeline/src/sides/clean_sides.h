// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/clean_mesh.h>
#include <posture/pipeline/observer.h>

#include "sides/side_surface.h"
#include <vector>

namespace posture {

struct CleanSides {
  CleanMesh source, target;
};

/// cleanMesh without the background, naming the side ("source") in what it throws. A mesh as it was
/// given is denoised first; the surface of a cloud was laid through denoised points. Of two meshes
/// as they were given, one that does not tell its outside is taken to be inside out where the other
/// one is: files of one origin look the same way.
CleanSides cleanSides(SideSurface& source, SideSurface& target);

std::vector<StagePicture> cleaningPictures(const CleanMesh& source, const CleanMesh& target);

}  // namespace posture
