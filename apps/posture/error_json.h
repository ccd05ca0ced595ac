// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/evaluation/map_error.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace posture::app {

using Json = nlohmann::ordered_json;

/// The figures of a map's errors; errors times 100, as they are reported. What is not known (no
/// pair was mapped) is null.
Json toJson(const MapErrors& errors);
Json toJson(const MirrorComparison& comparison);

/// A number in a document, by JSON pointer; NaN where it is missing or null.
double numberAt(const Json& document, const std::string& pointer);

/// The numbers at `pointer` of those documents that have one.
std::vector<double> figures(const std::vector<Json>& documents, const std::string& pointer);

/// NaN where there are none.
double largest(const std::vector<double>& values);

/// A share of 1 in per cent; "-" for NaN.
std::string percent(double share, int decimals = 1);

}  // namespace posture::app
