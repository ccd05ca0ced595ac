// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/point_cloud.h>
#include <posture/evaluation/pair_list.h>
#include <posture/evaluation/surface_fit.h>
#include <posture/pipeline/register_shapes.h>

#include "error_json.h"
#include <chrono>
#include <vector>

namespace posture::app {

/// What the files of a pair hold.
struct PairData {
  Shape source, target;
  std::vector<VertexPair> truth, mirror_truth;  ///< empty: not known
  double read_seconds = 0;                      ///< for the two shapes
};

/// \throws InputError  a file cannot be used.
PairData readPair(const BenchmarkPair& pair);

/// The part of a result that names its pair and method, the version, and what the files are like
/// now: a result of others is not this pair's.
Json describePair(const BenchmarkPair& pair, const std::string& method);

/// \throws InputError  its files' names or its texts are no UTF-8, in which results are written.
void checkText(const BenchmarkPair& pair);
/// The same of all pairs of a list, which the message names.
void checkTexts(const std::filesystem::path& list, const std::vector<BenchmarkPair>& pairs);

/// The places of a map at vertices, as the field measures it.
std::vector<SurfacePoint> atVertices(std::vector<SurfacePoint> places);

/// How the surfaces lie on each other, those of clouds laid through them.
/// \pre  the result has a deformed source.
SurfaceFit fitOf(const Shape& source, const Shape& target, const RegistrationResult& result);

double secondsSince(std::chrono::steady_clock::time_point start);

}  // namespace posture::app
