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
struct ChildRun {  // NOLINT(bugprone-exception-escape): taken for throwing because of Json's moves
  std::vector<std::string> arguments;  ///< the verb first; it writes the result
  std::filesystem::path result_file;
  Json described;  ///< the part of the result that names the run
  double time_limit = 0;
};

/// One of many.
struct PlannedRun {
  std::function<ChildRun()> run;  ///< as its files are when its turn comes
  std::string title;
  bool is_asked_for = true;  ///< else only a result that is there already is wanted
};

/// What is asked for is run where it has no stored result, or one of a run that crashed or took too
/// long, which may come out otherwise another time. Such a run has a result that says so.
/// \param fresh  run whatever is stored
/// \return the results there are then, in order: with those of a list in one place, a part that is
///         run again updates its lines.
std::vector<Json> runAll(const std::vector<PlannedRun>& runs, bool fresh, bool quiet);

/// The result of a run that came to nothing.
/// \param status  "not run": the input cannot be used; "failed": crashed or took too long.
Json failedRun(const Json& described, const std::string& status, const std::string& message);

}  // namespace posture::app
