// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/atomic_file.h>

#include "child_process.h"
#include "child_run.h"
#include "common/in_range.h"
#include "compare_report.h"
#include "compare_run.h"
#include "compare_variation.h"
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

struct CompareOptions {
  fs::path source;  // or the list
  fs::path target;  // empty: a list is given
  fs::path truth, mirror_truth, folder;
  PairSelection selection;
  std::vector<std::string> methods, variations;
  bool fresh = false;
  double time_limit = 900;  // seconds a run
};

std::vector<std::string> methodKeys() {
  std::vector<std::string> keys;
  for (const ComparedMethod& method : comparedMethods()) keys.push_back(method.key);
  return keys;
}

bool isAsked(const ComparedRun& run, const CompareOptions& options) {
  return options.selection.has(run.pair) && isAmong(options.methods, run.method) &&
         isAmong(options.variations, run.variation);
}

/// A shape alone, whose TARGET was forgotten, is no list.
std::vector<BenchmarkPair> listOf(const CompareOptions& options) {
  try {
    return readPairList(options.source);
  } catch (const InputError& error) {
    throw InputError(std::string(error.what()) + "; without TARGET it has to be a list of pairs");
  }
}

/// The list, or the pair that is given; its files are read now, not in the last of many runs.
std::vector<BenchmarkPair> pairsOf(const CompareOptions& options) {
  if (options.target.empty()) {
    if (!options.truth.empty() || !options.mirror_truth.empty())
      throw CLI::ValidationError("--truth and --mirror", "are for SOURCE and TARGET");
    std::vector<BenchmarkPair> pairs = listOf(options);
    options.selection.check(pairs);
    checkTexts(options.source, pairs);
    return pairs;
  }
  if (!options.selection.empty())
    throw CLI::ValidationError("--family and --pair", "are for a list of pairs");
  BenchmarkPair pair;
  pair.id = "pair";
  pair.source = options.source;
  pair.target = options.target;
  pair.truth = options.truth;
  pair.mirror_truth = options.mirror_truth;
  checkText(pair);
  readPair(pair);
  return {pair};
}

/// All there are, in the order of the tables.
std::vector<ComparedRun> runsOf(const std::vector<BenchmarkPair>& pairs, const Common& common) {
  std::vector<ComparedRun> runs;
  for (const BenchmarkPair& pair : pairs)
    for (const std::string& variation : variations())
      for (const std::string& method : methodKeys())
        runs.push_back({pair, method, variation, common.seed});
  return runs;
}

ChildRun childRun(const ComparedRun& run, const CompareOptions& options, const Common& common) {
  ChildRun child;
  child.described = describeRun(run);
  child.result_file =
      options.folder / "runs" / (run.pair.id + "." + run.variation + "." + run.method + ".json");
  child.arguments = {"compare-run"};
  if (common.threads > 0)
    child.arguments.insert(child.arguments.end(), {"--threads", std::to_string(common.threads)});
  // A folder may begin with a dash.
  child.arguments.insert(child.arguments.end(),
                         {"--", child.described.dump(), child.result_file.string()});
  child.time_limit = options.time_limit;
  return child;
}

void print(const Comparison& comparison, const fs::path& folder) {
  std::printf("%s\n%s\n", toText(comparison.errors).c_str(), toText(comparison.fits).c_str());
  for (const std::string& verdict : comparison.verdicts) std::printf("%s\n", verdict.c_str());
  std::printf("What the columns are: %s\n", (folder / "comparison.md").c_str());
}

void compare(const CompareOptions& options, const Common& common) {
  const std::vector<BenchmarkPair> pairs = pairsOf(options);
  const OutputFolder folder(options.folder / "runs");
  std::vector<fs::path> inputs = filesOf(pairs);
  inputs.push_back(options.source);  // where it is a list
  requireNoInput(options.folder, comparisonFiles(), inputs);
  checkWritable(options.folder / "comparison.md");
  std::vector<PlannedRun> planned;
  for (const ComparedRun& run : runsOf(pairs, common))
    planned.push_back({[&options, &common, run] { return childRun(run, options, common); },
                       run.pair.id + " " + run.variation + " " + run.method,
                       isAsked(run, options)});
  const std::vector<Json> results = runAll(planned, options.fresh, common.quiet);
  const Comparison comparison = summarizeRuns(results);
  const Json summary = writeComparison(results, comparison, options.folder);
  if (common.json)
    std::cout << documentText(summary);
  else if (!common.quiet)
    print(comparison, options.folder);
}

struct ChildOptions {
  std::string request;
  fs::path result;
  int parent = 0;
};

void compareRun(const ChildOptions& options) {
  endWithParent(options.parent);
  const ComparedRun run = comparedRun(Json::parse(options.request));
  writeFile(options.result, documentText(runCompared(run)));
}

}  // namespace

void addCompare(CLI::App& app, Common& common) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* verb = app.add_subcommand(
      "compare", "Registration beside PCL's rigid ones (ICP, GICP, NDT, features): one table");
  verb->add_option("SOURCE", options->source, "Mesh or points; alone: a CSV list of pairs")
      ->required();
  verb->add_option("TARGET", options->target, "The same, in any frame and unit");
  CLI::Option* truth =
      verb->add_option("--truth", options->truth, "File of `source target` rows, or: identity");
  verb->add_option(
          "--mirror", options->mirror_truth, "As --truth, for the left-right mirrored answer")
      ->needs(truth);
  verb->add_option("-o,--output", options->folder, "Folder for the results")->required();
  addSelection(*verb, options->selection);
  verb->add_option("--method", options->methods, "Only this method (repeatable)")
      ->check(CLI::IsMember(methodKeys()))
      ->expected(1)
      ->take_all();
  verb->add_option("--variation",
                   options->variations,
                   "Only the source aligned: as given; turned; or scaled: turned, a thousand times "
                   "as large and shuffled (repeatable)")
      ->check(CLI::IsMember(variations()))
      ->expected(1)
      ->take_all();
  verb->add_flag("--fresh", options->fresh, "Run again also what has a result");
  verb->add_option("--time-limit", options->time_limit, "Seconds after which a run has failed")
      ->check(inRange(0.001, 1e6))
      ->capture_default_str();
  verb->callback([options, &common] { compare(*options, common); });

  auto child = std::make_shared<ChildOptions>();
  CLI::App* hidden = app.add_subcommand("compare-run", "One run of a comparison")->group("");
  hidden->add_option("REQUEST", child->request)->required();
  hidden->add_option("RESULT", child->result)->required();
  hidden->add_option("--parent", child->parent)->required();
  hidden->callback([child] { compareRun(*child); });
}

}  // namespace posture::app
