// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>
#include <posture/refine/sample_maps.h>

namespace posture {

/// Two maps whose matches lie farther apart than this in the mean are different answers: twice the
/// spacing of the samples, in working units, square roots of the body's area.
inline double answerGap(const SampledShape& target) { return 2 * target.spacing; }

/// Mean distance between where two maps take the source's vertices on the target, straight, in
/// working units.
double gapBetween(const TriangleMesh& target, const VertexMaps& x, const VertexMaps& y);

/// The same over the vertices that have a counterpart under both; infinite where there are none.
double gapBetween(const TriangleMesh& target, const BentPair& x, const BentPair& y);

}  // namespace posture
