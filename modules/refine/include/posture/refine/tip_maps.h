// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/sample_maps.h>

#include <vector>

namespace posture {

/// The tips of a body, of its limbs, tail and head: samples farther from all others, in the mean,
/// than those around them. The farthest first.
/// \pre  distances about in square roots of the area.
std::vector<int> tipsOf(const SampledShape& shape);

/// Maps between the samples of two shapes that take tips to tips: where bodies stretch or lack
/// parts, the maps that change distances least shorten limbs or leave them out. Which tip goes to
/// which is decided by how thick the limbs are and, roughly, by how far apart they lie; mirrored
/// ways are among them. The most likely first, at most `most`; none where one of the shapes has too
/// few tips.
///
/// \pre  both in one unit, about the square roots of their areas.
std::vector<SampleMap> tipMaps(const SampledShape& a, const SampledShape& b, int most);

/// The map that takes each sample to the one that lies most alike between known places.
/// \param from_a, from_b  samples x places, at least one: geodesic distances from the same places
///        of both, in one order.
/// \pre  both in one unit.
SampleMap mapBetweenPlaces(const SampledShape& a,
                           const Matrix& from_a,
                           const SampledShape& b,
                           const Matrix& from_b);

}  // namespace posture
