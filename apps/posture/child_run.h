// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_document.h"
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace posture::app {

/// A run in a process of its own whose result is kept in a file.
struct ChildRun {
  std::vector<std::string> arguments;  ///< the verb first; it writes the result
  std::filesystem::path result_file;
  Json described;  ///< the part of the result that names the run
  double time_limit = 0;
};

/// The stored result, perhaps of a run that was cut short; null where there is none, it is damaged
/// or is of another run.
Json storedResult(const ChildRun& run);

/// Whether the run crashed or took too long: it may come out otherwise another time.
bool wasCutShort(const Json& result);

/// Runs it, whatever is stored. A run that crashes or takes too long has a result that says so.
Json runInChild(const ChildRun& run, const std::function<void()>& waiting);

/// The result of a run that came to nothing.
/// \param status  "not run": the input cannot be used; "failed": crashed or took too long.
Json failedRun(const Json& described, const std::string& status, const std::string& message);

}  // namespace posture::app
