// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/surface.h>

#include "refined/work/refined_shape.h"

namespace posture {

/// Places farther apart than two samples are not the same: no unit.
inline double answerGap(const SampledShape& target) { return 2 * target.spacing; }

/// Mean distance on the target between where two maps take the source's vertices, straight: no
/// unit, as the body's area is about one.
double gapBetween(const TriangleMesh& target, const VertexMaps& x, const VertexMaps& y);

/// The same over the vertices that have a counterpart under both; infinite where there are none.
double gapBetween(const TriangleMesh& target, const BentPair& x, const BentPair& y);

}  // namespace posture
