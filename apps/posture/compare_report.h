// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/report/table.h>

#include "json_document.h"
#include <filesystem>
#include <string>
#include <vector>

namespace posture::app {

/// What several runs of runCompared() come to.
struct Comparison {
  TextTable errors;  ///< a row a method and variation; of a single pair with all its figures
  TextTable fits;    ///< distances, coverage: what can be said without a truth
  std::vector<std::string> verdicts;  ///< sentences: which method is the best one
};

/// \param runs  in the order of the tables.
Comparison summarizeRuns(const std::vector<Json>& runs);

/// What writeComparison() may write.
std::vector<std::string> comparisonFiles();

/// Writes comparison.csv, comparison.json, comparison.md and, of each variation with a truth,
/// curves-VARIATION.svg into `folder`; returns what comparison.json holds.
Json writeComparison(const std::vector<Json>& runs,
                     const Comparison& comparison,
                     const std::filesystem::path& folder);

}  // namespace posture::app
