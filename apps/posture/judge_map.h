// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/evaluation/target_metric.h>

#include "json_document.h"
#include "target_places.h"
#include <vector>

namespace posture::app {

/// The errors of a map as results have them: `errors`, of its vertices, as the field measures it;
/// `subvertex_mean_x100`, of its places in faces; and, where a mirror truth is known, `mirror`.
/// \param on_target  a place for each vertex (point) of the source, as it was registered
/// \param truth      pairs of a source and a target vertex (point)
Json judgeMap(const TargetPlaces& target,
              const TargetMetric& metric,
              const std::vector<SurfacePoint>& on_target,
              const std::vector<VertexPair>& truth,
              const std::vector<VertexPair>& mirror_truth);

}  // namespace posture::app
