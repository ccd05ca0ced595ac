// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/report/colors.h>
#include <posture/report/report_html.h>
#include <posture/report/report_json.h>

#include "folder.h"
#include "progress.h"
#include "stage_dump.h"
#include "verbs.h"
#include <chrono>
#include <cstdio>
#include <memory>
#include <omp.h>
#include <optional>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

struct RegisterOptions {
  fs::path source, target, folder, dump;
  bool paper = false, alternatives = false;
};

/// The pipeline speaks of "source" and "target"; the user knows the files.
RegistrationResult registerFiles(const RegisterOptions& options,
                                 const TriangleMesh& source,
                                 const TriangleMesh& target,
                                 const Observer& observer) {
  try {
    RegistrationOptions registration;
    registration.method = options.paper ? Method::PAPER : Method::REFINED;
    registration.refine_alternatives = options.alternatives;
    return registerShapes(source, target, registration, observer);
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const auto& [side, file] :
         {std::pair("source ", &options.source), std::pair("target ", &options.target)})
      if (message.rfind(side, 0) == 0)
        throw InputError(file->string() + ": " + message.substr(std::string(side).size()));
    throw;
  }
}

RunDescription describe(const RegisterOptions& options, double seconds) {
  RunDescription run;
  run.source = options.source.string();
  run.target = options.target.string();
  run.options = {{"method", options.paper ? "paper" : "refined"}};
  run.files = {{"correspondence.csv", "for each source vertex its place on the target"},
               {"registered.ply", "the source, moved onto the target"},
               {"source_colored.ply", "the source, one colour a place; grey: no counterpart"},
               {"target_colored.ply", "the target, in the colours of its counterparts"}};
  run.threads = omp_get_max_threads();
  run.seconds = seconds;
  return run;
}

/// The answers that were not chosen, each as a table and as the target in the source's colours.
void writeAlternatives(const fs::path& folder,
                       const TriangleMesh& source,
                       const TriangleMesh& target,
                       const RegistrationResult& result) {
  for (std::size_t k = 0; k < result.alternatives.size(); ++k) {
    if (static_cast<int>(k) == result.chosen) continue;
    const Correspondence& other = result.alternatives[k].correspondence;
    const std::string name = "alternative-" + std::to_string(k);
    writeCorrespondence(folder / (name + ".csv"), other);
    writeMesh(folder / (name + "_target_colored.ply"),
              target,
              transferColors(placeColors(source.vertices), other, target));
  }
}

void writeResults(const RegisterOptions& options,
                  const TriangleMesh& source,
                  const TriangleMesh& target,
                  const RegistrationResult& result,
                  const RunDescription& run) {
  const Colors colors = placeColors(source.vertices);
  writeCorrespondence(options.folder / "correspondence.csv", result.correspondence);
  writeMesh(options.folder / "registered.ply", {result.deformed, source.faces}, colors);
  writeMesh(options.folder / "source_colored.ply",
            source,
            greyWhereRejected(colors, result.correspondence));
  writeMesh(options.folder / "target_colored.ply",
            target,
            transferColors(colors, result.correspondence, target));
  if (options.alternatives) writeAlternatives(options.folder, source, target, result);
  writeText(options.folder / "report.json", reportJson(result, run));
  writeText(options.folder / "report.html", reportHtml(result, run));
}

void registerVerb(const RegisterOptions& options, Common& common) {
  const auto start = std::chrono::steady_clock::now();
  ProgressBar bar(common.quiet);
  bar.show("reading", 0);
  const TriangleMesh source = readMesh(options.source).mesh;
  const TriangleMesh target = readMesh(options.target).mesh;
  makeFolder(options.folder);
  checkWritable(options.folder / "report.json");  // now, not after minutes
  std::optional<StageDump> dump;
  if (!options.dump.empty()) dump.emplace(options.dump);
  const RegistrationResult result =
      registerFiles(options, source, target, [&](const StageEvent& event) {
        bar.show(event.stage, event.progress);
        if (dump) dump->write(event);
      });
  bar.show("writing", 1);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const RunDescription run = describe(options, elapsed.count());
  writeResults(options, source, target, result, run);
  bar.clear();

  if (common.json) std::printf("%s", reportJson(result, run).c_str());
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
  verb->add_option("SOURCE", options->source, "Mesh: PLY, OBJ, OFF, STL or VTK")->required();
  verb->add_option("TARGET", options->target, "Mesh, in any frame and unit")->required();
  verb->add_option("-o,--output", options->folder, "Folder for the results")->required();
  verb->add_flag(
      "--paper",
      options->paper,
      "Register as Wuhrer, Shu and Bose published it in 2009: good to a few edges, and a body "
      "with two like sides often comes out mirrored");
  verb->add_flag("--alternatives",
                 options->alternatives,
                 "Also write the different answers that were not chosen: alternative-1.csv, ...")
      ->excludes("--paper");
  verb->add_option("--dump", options->dump, "Folder for every stage's result as PLY files");
  verb->callback([options, &common] { registerVerb(*options, common); });
}

}  // namespace posture::app
