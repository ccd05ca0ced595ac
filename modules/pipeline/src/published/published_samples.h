// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/dense/dense_map.h>
#include <posture/pipeline/observer.h>

#include <vector>

namespace posture {

/// What to multiply source lengths by so that both shapes are of one size: scans come in any unit.
/// The ratio of the mean geodesic distances between samples, weighted by their confidence.
double commonScale(const Landmarks& source, const Landmarks& target);

/// Multiplies all lengths of a shape that has no canonical form yet.
void rescale(EmbeddedShape& shape, double scale);

std::vector<StagePicture> samplePictures(const EmbeddedShape& source, const EmbeddedShape& target);
std::vector<StagePicture> formPictures(const EmbeddedShape& source, const EmbeddedShape& target);

}  // namespace posture
