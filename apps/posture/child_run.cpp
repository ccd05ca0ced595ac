// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "child_run.h"

#include <posture/io/atomic_file.h>

#include "child_process.h"
#include "folder.h"
#include "run_progress.h"
#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <utility>

namespace posture::app {

namespace {

/// Perhaps of a run that was cut short; null where there is none, it is damaged or is of another
/// run.
Json storedResult(const ChildRun& run) {
  std::ifstream file(run.result_file);
  Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("status")) return nullptr;
  for (const auto& [key, value] : run.described.items())
    if (!json.contains(key) || json[key] != value) return nullptr;
  return json;
}

/// Crashed or took too long, or files could not be read, which may have to do with more than them.
bool mayGoBetter(const Json& result) {
  return result.value("cut_short", false) || result.value("status", "") == "not run";
}

Json runInChild(const ChildRun& run, const std::function<void()>& waiting) {
  std::filesystem::remove(run.result_file);
  const ChildEnd end =
      runSelf(run.arguments, std::chrono::duration<double>(run.time_limit), waiting);
  Json result = end.succeeded || !end.is_known ? storedResult(run) : Json();
  if (result.is_null()) {
    result = failedRun(
        run.described, "failed", end.succeeded ? "left no result of these files" : end.reason);
    result["cut_short"] = true;
    writeFile(run.result_file, documentText(result));
  }
  return result;
}

/// Null where only a stored one is wanted, and there is none.
Json resultOf(const PlannedRun& planned, bool fresh, RunProgress& progress) {
  const ChildRun run = planned.run();
  Json stored = storedResult(run);
  if (!planned.is_asked_for) return stored;
  progress.begin(planned.title);
  if (!fresh && !stored.is_null() && !mayGoBetter(stored)) return stored;
  Json result = runInChild(run, [&] { progress.wait(); });
  progress.end(result);
  return result;
}

}  // namespace

std::vector<Json> runAll(const std::vector<PlannedRun>& runs, bool fresh, bool quiet) {
  RunProgress progress(
      quiet, static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), [](const auto& p) {
        return p.is_asked_for;
      })));
  std::vector<Json> results;
  for (const PlannedRun& planned : runs) {
    Json result = resultOf(planned, fresh, progress);
    if (!result.is_null()) results.push_back(std::move(result));
  }
  return results;
}

Json failedRun(const Json& described, const std::string& status, const std::string& message) {
  Json json = described;
  json["status"] = status;
  json["message"] = message;
  return json;
}

}  // namespace posture::app
