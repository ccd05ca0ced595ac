// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/clean_mesh.h>
#include <posture/pipeline/observer.h>

#include "scan_side.h"
#include <string>
#include <vector>

namespace posture {

/// cleanMesh, naming the side ("source") in what it throws. A mesh as it was given is denoised
/// first; the surface of a cloud was laid through denoised points.
CleanMesh cleanSide(const std::string& side, SideSurface& surface);

std::vector<StagePicture> cleaningPictures(const CleanMesh& source, const CleanMesh& target);

}  // namespace posture
