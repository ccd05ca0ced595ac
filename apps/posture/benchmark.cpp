// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/atomic_file.h>

#include "benchmark_pair.h"
#include "benchmark_report.h"
#include "child_process.h"
#include "child_run.h"
#include "common/in_range.h"
#include "folder.h"
#include "pair_data.h"
#include "pair_selection.h"
#include "verbs.h"
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

struct BenchmarkOptions {
  fs::path list;
  fs::path folder;
  PairSelection selection;
  bool fresh = false, paper = false;
  double time_limit = 900;  // seconds a pair

  Method method() const { return paper ? Method::PAPER : Method::REFINED; }
};

ChildRun childRun(const BenchmarkPair& pair,
                  const BenchmarkOptions& options,
                  const Common& common) {
  ChildRun run;
  run.result_file = options.folder / "pairs" / (pair.id + ".json");
  run.arguments = {"benchmark-pair"};
  if (options.paper) run.arguments.emplace_back("--paper");
  if (common.threads > 0)
    run.arguments.insert(run.arguments.end(), {"--threads", std::to_string(common.threads)});
  // An id may begin with a dash.
  run.arguments.insert(run.arguments.end(),
                       {"--", options.list.string(), pair.id, run.result_file.string()});
  run.described = describePair(pair, nameOf(options.method()));
  run.time_limit = options.time_limit;
  return run;
}

int countOf(const std::vector<Json>& results, const std::string& status) {
  return static_cast<int>(std::count_if(results.begin(), results.end(), [&](const Json& r) {
    return r.value("status", "") == status;
  }));
}

void benchmark(const BenchmarkOptions& options, const Common& common) {
  const std::vector<BenchmarkPair> pairs = readPairList(options.list);
  options.selection.check(pairs);
  checkTexts(options.list, pairs);
  const OutputFolder folder(options.folder / "pairs");
  std::vector<fs::path> inputs = filesOf(pairs);
  inputs.push_back(options.list);
  requireNoInput(options.folder, benchmarkReportFiles(), inputs);
  checkWritable(options.folder / "RESULTS.md");  // now, not after hours

  std::vector<PlannedRun> runs;
  runs.reserve(pairs.size());
  for (const BenchmarkPair& pair : pairs)
    runs.push_back(
        {[&] { return childRun(pair, options, common); }, pair.id, options.selection.has(pair)});
  const std::vector<Json> results = runAll(runs, options.fresh, common.quiet);
  const Json summary = writeBenchmarkReport(results, pairs.size(), options.folder);
  if (common.json)
    std::cout << documentText(summary);
  else if (!common.quiet)
    std::printf("%zu %s: %d registered, %d undecided, %d not run, %d failed; see %s\n",
                results.size(),
                results.size() == 1 ? "pair" : "pairs",
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
  int parent = 0;
};

void benchmarkPair(const ChildOptions& options) {
  endWithParent(options.parent);
  for (const BenchmarkPair& pair : readPairList(options.list))
    if (pair.id == options.id) {
      const Json result = runPair(pair, options.paper ? Method::PAPER : Method::REFINED);
      return writeFile(options.result, documentText(result));
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
  addSelection(*verb, options->selection);
  verb->add_flag("--paper", options->paper, "Register as published, as `register --paper` does");
  verb->add_flag("--fresh", options->fresh, "Run again also what has a result");
  verb->add_option("--time-limit", options->time_limit, "Seconds after which a pair has failed")
      ->check(inRange(0.001, 1e6))
      ->capture_default_str();
  verb->callback([options, &common] { benchmark(*options, common); });

  auto child = std::make_shared<ChildOptions>();
  CLI::App* hidden = app.add_subcommand("benchmark-pair", "One pair of a list")->group("");
  hidden->add_option("PAIRS", child->list)->required();
  hidden->add_option("ID", child->id)->required();
  hidden->add_option("RESULT", child->result)->required();
  hidden->add_flag("--paper", child->paper);
  hidden->add_option("--parent", child->parent)->required();
  hidden->callback([child] { benchmarkPair(*child); });
}

}  // namespace posture::app
