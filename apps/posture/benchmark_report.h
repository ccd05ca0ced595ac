// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_document.h"
#include "trust_curve.h"
#include <filesystem>
#include <string>
#include <vector>

namespace posture::app {

/// What the results of each family come to: medians over its pairs, counts, largest values.
/// Families are in the order of their first pair. `results` are what runPair() and failedRun()
/// made.
Json summarizeFamilies(const std::vector<Json>& results);

/// RESULTS.md: the tables a person reads.
std::string benchmarkPage(const std::vector<Json>& results,
                          const Json& families,
                          const TrustCurve& trust,
                          std::size_t listed);

/// What writeBenchmarkReport() may write.
std::vector<std::string> benchmarkReportFiles();

/// Writes results.csv, results.json, RESULTS.md, curves.svg, histogram.svg and,
/// where good and bad pairs are there to tell apart, trust.svg into `folder`;
/// returns what results.json holds. \param listed  pairs in the list, with a result or without.
Json writeBenchmarkReport(const std::vector<Json>& results,
                          std::size_t listed,
                          const std::filesystem::path& folder);

}  // namespace posture::app
