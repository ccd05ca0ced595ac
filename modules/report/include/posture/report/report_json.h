// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include <string>
#include <utility>
#include <vector>

namespace posture {

/// What a report says besides the result.
struct RunDescription {
  std::string source, target;  ///< the files, as they were named
  std::vector<std::pair<std::string, std::string>> options;
  std::vector<std::pair<std::string, std::string>> files;  ///< written: name, what it holds
  int threads = 0;
  double seconds = 0;  ///< of the whole run
};

/// report.json: everything a registration found out, so named that it explains itself. Infinity and
/// NaN are null. Two runs on the same input differ in the object "run" at the end alone: times,
/// memory, threads.
std::string reportJson(const RegistrationResult& result, const RunDescription& run);

/// The same of a surface laid through points, as an object of its own.
std::string reconstructionJson(const ReconstructionSummary& summary);

/// How much worse the second least deformed candidate is than the chosen one: its E_D divided by
/// the chosen one's. Near 1 the two can hardly be told apart; infinity or NaN: there is no other.
double runnerUpRatio(const RegistrationResult& result);

}  // namespace posture
