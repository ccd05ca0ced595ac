// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/point_cloud.h>
#include <posture/evaluation/pair_list.h>
#include <posture/evaluation/surface_fit.h>
#include <posture/pipeline/register_shapes.h>

#include "json_document.h"
#include "target_places.h"
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace posture::app {

/// What the files of a pair hold.
struct PairData {
  Shape source, target;
  std::vector<VertexPair> truth, mirror_truth;  ///< empty: not known
  std::optional<TargetPlaces> on_surface;       ///< where the pair names one to measure on
  double read_seconds = 0;                      ///< for the two shapes
};

/// Reads all of them, before anything is registered. \throws InputError  a file cannot be used.
PairData readPair(const BenchmarkPair& pair);

/// Where the pair's errors are measured. \param scan  of the target, where it is a cloud.
TargetPlaces placesOf(const BenchmarkPair& pair,
                      const PairData& data,
                      const std::optional<ScanSurface>& scan);

/// All files that pairs name.
std::vector<std::filesystem::path> filesOf(const std::vector<BenchmarkPair>& pairs);

/// The part of a result that names its pair and method, the version, and what the files are like
/// now: a result of others is not this pair's.
Json describePair(const BenchmarkPair& pair, const std::string& method);

/// \throws InputError  the name of one of its files or one of its texts is not UTF-8, in which
/// results are written.
void checkText(const BenchmarkPair& pair);
/// The same of all pairs of a list, which the message names.
void checkTexts(const std::filesystem::path& list, const std::vector<BenchmarkPair>& pairs);

/// How the surfaces lie on each other, those of clouds laid through them.
/// \pre  the result has a deformed source.
SurfaceFit fitOf(const Shape& source, const Shape& target, const RegistrationResult& result);

}  // namespace posture::app
