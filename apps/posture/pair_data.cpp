// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pair_data.h"

#include <posture/core/error.h>
#include <posture/core/seconds_since.h>
#include <posture/core/utf8.h>
#include <posture/evaluation/truth.h>
#include <posture/io/shape_io.h>

#include <system_error>

namespace posture::app {
namespace {

/// Size and time of the last change, by which a file is known to be the same; null where there is
/// none. \param file  may also be empty, or a truth that is no file.
Json stampOf(const std::filesystem::path& file) {
  std::error_code no_size, no_time;
  const auto size = std::filesystem::file_size(file, no_size);
  const auto changed = std::filesystem::last_write_time(file, no_time);
  if (no_size || no_time) return nullptr;
  return Json::array({size, changed.time_since_epoch().count()});
}

}  // namespace

PairData readPair(const BenchmarkPair& pair) {
  PairData data;
  const auto start = std::chrono::steady_clock::now();
  data.source = readShape(pair.source);
  data.target = readShape(pair.target);
  data.read_seconds = secondsSince(start);
  const int n = static_cast<int>(data.source.cloud.points.rows());
  const int m = static_cast<int>(data.target.cloud.points.rows());
  if (!pair.truth.empty()) data.truth = readTruth(pair.truth, n, m);
  if (!pair.mirror_truth.empty()) data.mirror_truth = readTruth(pair.mirror_truth, n, m);
  if (!pair.target_surface.empty())
    data.on_surface.emplace(
        pair.target, data.target, pair.target_surface, pair.target_surface_vertices, data.truth);
  return data;
}

TargetPlaces placesOf(const BenchmarkPair& pair,
                      const PairData& data,
                      const std::optional<ScanSurface>& scan) {
  return data.on_surface ? *data.on_surface : TargetPlaces(pair.target, data.target, scan);
}

std::vector<std::filesystem::path> filesOf(const std::vector<BenchmarkPair>& pairs) {
  std::vector<std::filesystem::path> files;
  for (const BenchmarkPair& pair : pairs)
    for (const std::filesystem::path& file : {pair.source,
                                              pair.target,
                                              pair.truth,
                                              pair.mirror_truth,
                                              pair.target_surface,
                                              pair.target_surface_vertices})
      if (!file.empty() && file != "identity") files.push_back(file);
  return files;
}

Json describePair(const BenchmarkPair& pair, const std::string& method) {
  return {{"id", pair.id},
          {"method", method},
          {"family", pair.family},
          {"kind", pair.kind},
          {"source", pair.source.string()},
          {"target", pair.target.string()},
          {"truth", pair.truth.string()},
          {"mirror_truth", pair.mirror_truth.string()},
          {"note", pair.note},
          {"target_surface", pair.target_surface.string()},
          {"target_surface_vertices", pair.target_surface_vertices.string()},
          {"version", POSTURE_VERSION},
          {"stamps",
           {{"source", stampOf(pair.source)},
            {"target", stampOf(pair.target)},
            {"truth", stampOf(pair.truth)},
            {"mirror_truth", stampOf(pair.mirror_truth)},
            {"target_surface", stampOf(pair.target_surface)},
            {"target_surface_vertices", stampOf(pair.target_surface_vertices)}}}};
}

void checkText(const BenchmarkPair& pair) {
  for (const std::filesystem::path& file : filesOf({pair}))
    if (!isUtf8(file.string())) throw InputError(file.string() + ": a name that is not UTF-8");
  for (const std::string& text : {pair.id, pair.family, pair.kind, pair.note})
    if (!isUtf8(text)) throw InputError("pair " + pair.id + ": a text that is not UTF-8");
}

void checkTexts(const std::filesystem::path& list, const std::vector<BenchmarkPair>& pairs) {
  try {
    for (const BenchmarkPair& pair : pairs) checkText(pair);
  } catch (const InputError& error) {
    throw InputError(list.string() + ": " + error.what());
  }
}

SurfaceFit fitOf(const Shape& source, const Shape& target, const RegistrationResult& result) {
  return measureFit(registeredMesh(source, result.source_scan, result.source_denoised),
                    result.source_scan ? result.surface_deformed : result.deformed,
                    result.scale,
                    registeredMesh(target, result.target_scan, result.target_denoised));
}

}  // namespace posture::app
