// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/seconds_since.h>
#include <posture/io/atomic_file.h>
#include <posture/io/shape_io.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/pipeline/segment_shape.h>
#include <posture/report/report_html.h>
#include <posture/report/report_json.h>

#include "folder.h"
#include "progress.h"
#include "register_files.h"
#include "result_files.h"
#include "stage_dump.h"
#include "surface_option.h"
#include "verbs.h"
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <omp.h>
#include <optional>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

struct RegisterOptions {
  fs::path source, target, folder, dump;
  bool paper = false, alternatives = false, both = false;
  SurfaceMethod surface = SurfaceMethod::TANGENT_DELAUNAY;
};

RunDescription describe(const RegisterOptions& options,
                        const RegistrationResult& result,
                        bool with_segments,
                        double seconds) {
  RunDescription run;
  run.source = options.source.string();
  run.target = options.target.string();
  const auto flag = [](bool is_set) { return is_set ? "true" : "false"; };
  run.options = {{"method", options.paper ? "paper" : "refined"},
                 {"surface", nameOf(options.surface)},
                 {"both", flag(options.both)},
                 {"alternatives", flag(options.alternatives)}};
  run.files = resultFiles(result, with_segments);
  run.threads = omp_get_max_threads();
  run.seconds = seconds;
  return run;
}

void registerVerb(const RegisterOptions& options, Common& common) {
  const auto start = std::chrono::steady_clock::now();
  ProgressBar bar(common.quiet);
  bar.show("reading", 0);
  const ShapeFile source{options.source, readShape(options.source)},
      target{options.target, readShape(options.target)};
  const OutputFolder folder(options.folder);
  requireNoResultFiles(options.folder, {options.source, options.target});
  checkWritable(options.folder / "report.json");  // now, not after minutes
  std::optional<StageDump> dump;
  if (!options.dump.empty())
    dump.emplace(options.dump, std::vector{options.source, options.target});
  RegistrationOptions registration;
  registration.method = options.paper ? Method::PAPER : Method::REFINED;
  registration.refine_alternatives = options.alternatives;
  registration.both_ways = options.both;
  registration.surface = options.surface;
  const RegistrationResult result =
      registerFiles(source, target, registration, [&](const StageEvent& event) {
        bar.show(stageTitle(event.attempt, event.stage), event.progress);
        if (dump) dump->write(event);
      });
  std::optional<ShapeSegments> segments;
  try {
    if (result.status == Status::REGISTERED) segments = segmentShape(source.shape, {result});
  } catch (const std::exception& error) {  // what took minutes is not lost for it
    bar.clear();
    std::fprintf(stderr, "posture: without near-rigid parts: %s\n", error.what());
  }
  bar.show("writing", 1);
  const RunDescription run = describe(options, result, segments.has_value(), secondsSince(start));
  const std::string report = reportJson(result, run);  // once: it says how much memory was used
  removeResultFiles(options.folder);                   // no mix of two results
  try {
    writeResultFiles(options.folder, source.shape, target.shape, result, segments);
    writeFile(options.folder / "report.html", reportHtml(result, run));
    writeFile(options.folder / "report.json", report);
  } catch (...) {  // no part of one either
    removeResultFiles(options.folder);
    throw;
  }
  bar.clear();

  if (common.json) std::printf("%s", report.c_str());
  if (result.status == Status::UNDECIDED) {
    common.exit_code = EXIT_UNDECIDED;
    std::fprintf(stderr, "posture: %s\n", result.message.c_str());
  } else if (!common.quiet && !common.json) {
    std::printf("%s\n", result.message.c_str());
  }
}

}  // namespace

void addRegister(CLI::App& app, Common& common) {
  auto options = std::make_shared<RegisterOptions>();
  CLI::App* verb = app.add_subcommand(
      "register", "Find for every point of SOURCE where it is on TARGET, a body in another pose");
  verb->add_option("SOURCE",
                   options->source,
                   "Mesh (PLY, OBJ, OFF, STL, VTK) or points (PCD, PLY, XYZ, TXT, CSV, PTS)")
      ->required();
  verb->add_option("TARGET", options->target, "The same, in any frame and unit")->required();
  verb->add_option("-o,--output", options->folder, "Folder for the results")->required();
  verb->add_flag(
      "--paper",
      options->paper,
      "Register as Wuhrer, Shu and Bose published it in 2009: good to a few edges, and a body "
      "with two like sides often comes out mirrored");
  verb->add_flag("--alternatives",
                 options->alternatives,
                 "Also write the different answers that were not chosen: alternative-N.csv, N as "
                 "in the report, from 0")
      ->excludes("--paper");
  verb->add_flag("--both",
                 options->both,
                 "Also write the way back, from TARGET to SOURCE: correspondence_back.csv")
      ->excludes("--paper");
  addSurfaceOption(verb, options->surface);
  verb->add_option("--dump", options->dump, "Folder for every stage's result as PLY files");
  verb->callback([options, &common] { registerVerb(*options, common); });
}

}  // namespace posture::app
