// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/dense/dense_map.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/pipeline/observer.h>

#include "scan_side.h"
#include <string>
#include <vector>

namespace posture {

/// cleanMesh, naming the side ("source") in what it throws. A mesh as it was given is denoised
/// first; the surface of a cloud was laid through denoised points.
CleanMesh cleanSide(const std::string& side, SideSurface& surface);

/// Voronoi samples with distances and confidences. \throws InputError  too few to tell a shape.
Landmarks sampleSide(const std::string& side, const TriangleMesh& mesh);

/// What to multiply source lengths by so that both shapes are of one size: scans come in any unit.
/// The ratio of the mean geodesic distances between samples, weighted by their confidence.
double commonScale(const Landmarks& source, const Landmarks& target);

/// Multiplies all lengths of a shape that has no canonical form yet.
void rescale(EmbeddedShape& shape, double scale);

std::vector<StagePicture> cleaningPictures(const CleanMesh& source, const CleanMesh& target);
std::vector<StagePicture> samplePictures(const EmbeddedShape& source, const EmbeddedShape& target);
std::vector<StagePicture> formPictures(const EmbeddedShape& source, const EmbeddedShape& target);

}  // namespace posture
