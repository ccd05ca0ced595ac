// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>

#include <CLI/CLI.hpp>

#include "common/in_range.h"
#include "verbs.h"
#include <cstdio>
#include <exception>
#include <glog/logging.h>
#include <limits>
#include <new>
#include <omp.h>
#include <string>
#include <vector>

namespace {

int fail(const char* message, int exit_code) noexcept {
  return posture::app::fail("posture", message, exit_code);
}

/// What is wrong with the arguments, and where to look them up.
std::string wrongUsage(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> verbs = app.get_subcommands();
  if (!verbs.empty())
    return std::string(error.what()) + " (see posture " + verbs.front()->get_name() + " --help)";
  const std::vector<std::string> unknown = app.remaining();
  std::string what = error.what();
  if (!unknown.empty())
    what = "'" + unknown.front() + "' is neither a verb nor an option";
  else if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError))
    what = "a verb is missing";
  return what + " (see posture --help)";
}

int run(int argc, char** argv) {
  using namespace posture::app;
  for (int i = 1; i < argc; ++i)
    if (*argv[i] == '\0')
      return fail(("the argument behind '" + std::string(argv[i - 1]) + "' is empty").c_str(),
                  EXIT_USAGE);
  FLAGS_minloglevel = google::GLOG_FATAL;  // what Ceres thinks of a line search is not for the user
  CLI::App app{
      "Registration of bodies that bend: for every point of one shape, where it is on the other."};
  app.name("posture");
  app.require_subcommand(1);
  app.fallthrough();
  app.set_version_flag("--version", POSTURE_VERSION);

  Common common;
  app.add_flag("-q,--quiet", common.quiet, "Say nothing but errors");
  app.add_flag("--json", common.json, "Print the result on stdout as JSON");
  app.add_option("--threads", common.threads, "Threads to use (default: all processors)")
      ->check(inRange(1, 1024));
  app.add_option("--seed",
                 common.seed,
                 "Seed of what is random: in synthesize and compare; nothing is elsewhere")
      ->check(inRange(0ul, std::numeric_limits<unsigned long>::max()));
  app.parse_complete_callback([&] {
    if (common.threads > 0) omp_set_num_threads(common.threads);
  });
  addRegister(app, common);
  addApply(app, common);
  addReconstruct(app, common);
  addSegment(app, common);
  addEvaluate(app, common);
  addBenchmark(app, common);
  addCompare(app, common);
  addSynthesize(app, common);
  addRender(app, common);
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    verb->footer("Also, as all verbs: -q,--quiet, --json, --threads, --seed; see posture --help");

  try {
    app.parse(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      return fail("stdout cannot be written", EXIT_INPUT);
    return common.exit_code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return fail(wrongUsage(app, error).c_str(), EXIT_USAGE);
  }
}

}  // namespace

int main(int argc, char** argv) {
  using posture::app::EXIT_INPUT;
  try {
    return run(argc, argv);
  } catch (const posture::InputError& error) {
    return fail(error.what(), EXIT_INPUT);
  } catch (const std::bad_alloc&) {
    return fail("the input does not fit into memory", EXIT_INPUT);
  } catch (const std::exception& error) {
    return fail(error.what(), EXIT_INPUT);
  }
}
