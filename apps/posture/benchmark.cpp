// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/report/table.h>

#include "benchmark_pair.h"
#include "benchmark_report.h"
#include "child_process.h"
#include "folder.h"
#include "verbs.h"
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

struct BenchmarkOptions {
  fs::path list;
  fs::path folder;
  std::vector<std::string> families, ids;
  bool fresh = false, paper = false;
  double time_limit = 900;  // seconds a pair

  Method method() const { return paper ? Method::PAPER : Method::REFINED; }
};

/// The stored result of a pair; null where there is none, it is damaged or is of other inputs.
Json storedResult(const fs::path& path, const BenchmarkPair& pair, Method method) {
  std::ifstream file(path);
  Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("status")) return nullptr;
  const Json described = describePair(pair, method);
  for (const char* key : {"id", "method", "source", "target", "truth", "mirror_truth"})
    if (json.value(key, "") != described[key]) return nullptr;
  return json;
}

/// Says on stderr how far the list is: one line that changes on a terminal, one line a pair
/// elsewhere.
class Progress {
 public:
  Progress(bool quiet, std::size_t pairs)
      : silent_(quiet), live_(!quiet && isatty(STDERR_FILENO) != 0), pairs_(pairs) {}

  void begin(const std::string& id) {
    ++pair_;
    id_ = id;
    start_ = std::chrono::steady_clock::now();
  }

  void wait() const {
    if (!live_) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
    std::fprintf(stderr, "\r\033[K%s  %.0f s", head().c_str(), seconds.count());
  }

  void end(const Json& result) const {
    if (silent_) return;
    std::string line = head() + "  " + result.value("status", "");
    const double error = numberAt(result, "/errors/mean_x100");
    const double seconds = numberAt(result, "/seconds");
    if (error == error) line += ", mean error " + formatFixed(error, 2);
    if (seconds == seconds) line += ", " + formatFixed(seconds, 1) + " s";
    const std::string message = result.value("message", "");
    if (!message.empty()) line += " (" + message + ")";
    std::fprintf(stderr, "%s%s\n", live_ ? "\r\033[K" : "", line.c_str());
  }

 private:
  std::string head() const {
    return "[" + std::to_string(pair_) + "/" + std::to_string(pairs_) + "] " + id_;
  }

  bool silent_, live_;
  std::size_t pairs_;
  std::size_t pair_ = 0;
  std::string id_;
  std::chrono::steady_clock::time_point start_;
};

void checkKnown(const std::vector<std::string>& asked,
                const std::vector<BenchmarkPair>& pairs,
                std::string BenchmarkPair::*member,
                const char* what) {
  for (const std::string& name : asked)
    if (std::none_of(pairs.begin(), pairs.end(), [&](const auto& p) { return p.*member == name; }))
      throw CLI::ValidationError(std::string("the list has no ") + what + " '" + name + "'");
}

bool isAsked(const BenchmarkPair& pair, const BenchmarkOptions& options) {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  return has(options.families, pair.family) && has(options.ids, pair.id);
}

Json runInChild(const BenchmarkPair& pair,
                const BenchmarkOptions& options,
                const Common& common,
                const Progress& progress) {
  const fs::path result_file = options.folder / "pairs" / (pair.id + ".json");
  fs::remove(result_file);
  std::vector<std::string> arguments{
      "benchmark-pair", options.list.string(), pair.id, result_file.string()};
  if (options.paper) arguments.emplace_back("--paper");
  if (common.threads > 0)
    arguments.insert(arguments.end(), {"--threads", std::to_string(common.threads)});
  const ChildEnd end = runSelf(
      arguments, std::chrono::duration<double>(options.time_limit), [&] { progress.wait(); });
  Json result = end.succeeded ? storedResult(result_file, pair, options.method()) : Json();
  if (result.is_null()) {
    result =
        failedPair(pair, options.method(), "failed", end.succeeded ? "left no result" : end.reason);
    writeText(result_file, result.dump(1) + "\n");
  }
  return result;
}

int countOf(const std::vector<Json>& results, const std::string& status) {
  return static_cast<int>(std::count_if(results.begin(), results.end(), [&](const Json& r) {
    return r.value("status", "") == status;
  }));
}

void benchmark(const BenchmarkOptions& options, const Common& common) {
  const std::vector<BenchmarkPair> pairs = readPairList(options.list);
  checkKnown(options.families, pairs, &BenchmarkPair::family, "family");
  checkKnown(options.ids, pairs, &BenchmarkPair::id, "pair");
  makeFolder(options.folder / "pairs");

  const auto asked = static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [&](const auto& pair) { return isAsked(pair, options); }));
  Progress progress(common.quiet, asked);
  std::vector<Json> results;  // of the whole list, so that a part run again updates its lines
  for (const BenchmarkPair& pair : pairs) {
    Json result =
        storedResult(options.folder / "pairs" / (pair.id + ".json"), pair, options.method());
    if (isAsked(pair, options)) {
      progress.begin(pair.id);
      if (options.fresh || result.is_null()) {
        result = runInChild(pair, options, common, progress);
        progress.end(result);
      }
    }
    if (!result.is_null()) results.push_back(std::move(result));
  }
  const Json summary = writeBenchmarkReport(results, pairs.size(), options.folder);
  if (common.json)
    std::cout << summary.dump(1) << '\n';
  else if (!common.quiet)
    std::printf("%zu pairs: %d registered, %d undecided, %d not run, %d failed; see %s\n",
                results.size(),
                countOf(results, "registered"),
                countOf(results, "undecided"),
                countOf(results, "not run"),
                countOf(results, "failed"),
                (options.folder / "RESULTS.md").c_str());
}

struct ChildOptions {
  fs::path list, result;
  std::string id;
  bool paper = false;
};

void benchmarkPair(const ChildOptions& options) {
  endWithParent();
  for (const BenchmarkPair& pair : readPairList(options.list))
    if (pair.id == options.id) {
      const Json result = runPair(pair, options.paper ? Method::PAPER : Method::REFINED);
      return writeText(options.result, result.dump(1) + "\n");
    }
  throw InputError(options.list.string() + ": has no pair '" + options.id + "'");
}

}  // namespace

void addBenchmark(CLI::App& app, Common& common) {
  auto options = std::make_shared<BenchmarkOptions>();
  CLI::App* verb = app.add_subcommand(
      "benchmark", "Register every pair of a list and say how good the maps are");
  verb->add_option("PAIRS", options->list, "CSV list of pairs")->required();
  verb->add_option("-o,--output", options->folder, "Folder for the results")->required();
  verb->add_option("--family", options->families, "Only pairs of this family (repeatable)");
  verb->add_option("--pair", options->ids, "Only the pair of this id (repeatable)");
  verb->add_flag("--paper", options->paper, "Register as published, as `register --paper` does");
  verb->add_flag("--fresh", options->fresh, "Run again what already has a result");
  verb->add_option("--time-limit", options->time_limit, "Seconds after which a pair has failed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->callback([options, &common] { benchmark(*options, common); });

  auto child = std::make_shared<ChildOptions>();
  CLI::App* hidden = app.add_subcommand("benchmark-pair", "One pair of a list")->group("");
  hidden->add_option("PAIRS", child->list)->required();
  hidden->add_option("ID", child->id)->required();
  hidden->add_option("RESULT", child->result)->required();
  hidden->add_flag("--paper", child->paper);
  hidden->callback([child] { benchmarkPair(*child); });
}

}  // namespace posture::app
