// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/evaluation/pair_list.h>
#include <posture/pipeline/register_shapes.h>

#include "json_document.h"
#include <string>

namespace posture::app {

/// "refined" or "paper".
std::string nameOf(Method method);

/// Registers a pair and judges the map. Input that cannot be used ends in a result that says so.
Json runPair(const BenchmarkPair& pair, Method method);

}  // namespace posture::app
