// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/evaluation/map_error.h>

#include "json_document.h"

namespace posture::app {

/// The figures of a map's errors; errors times 100, as they are reported. What is not known (no
/// pair was mapped) is null.
Json toJson(const MapErrors& errors);
Json toJson(const MirrorComparison& comparison);

/// The share of points with at most that error, one of curvePlaces(). \pre  `errors` is such a
/// document.
double curveAt(const Json& errors, double place);

}  // namespace posture::app
