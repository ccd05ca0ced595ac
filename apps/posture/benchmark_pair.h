// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/evaluation/pair_list.h>
#include <posture/pipeline/register_shapes.h>

#include "error_json.h"

namespace posture::app {

/// The part of a result that names its pair and method: a result of others is not this pair's.
Json describePair(const BenchmarkPair& pair, Method method);

/// Registers a pair and judges the map. Input that cannot be used ends in a result that says so.
Json runPair(const BenchmarkPair& pair, Method method);

/// The result of a pair that came to nothing.
/// \param status  "not run": the input cannot be used; "failed": crashed or took too long.
Json failedPair(const BenchmarkPair& pair,
                Method method,
                const std::string& status,
                const std::string& message);

}  // namespace posture::app
