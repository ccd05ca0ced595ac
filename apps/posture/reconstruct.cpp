// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>
#include <posture/report/report_json.h>
#include <posture/scan/reconstruct.h>

#include "common/endings.h"
#include "folder.h"
#include "result_files.h"
#include "surface_option.h"
#include "verbs.h"
#include <cstdio>
#include <filesystem>
#include <memory>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

struct ReconstructOptions {
  fs::path scan, mesh, link;
  ReconstructionOptions reconstruction;
};

ScanSurface reconstructFile(const ReconstructOptions& options) {
  const Shape shape = readShape(options.scan);
  if (shape.faces.rows() > 0)
    throw InputError(options.scan.string() + ": has faces already; it is no cloud of points");
  try {
    return posture::reconstruct(shape.cloud, options.reconstruction);
  } catch (const InputError& error) {
    throw InputError(options.scan.string() + ": " + error.what());
  }
}

/// However it is written.
fs::path placeOf(const fs::path& file) { return fs::weakly_canonical(fs::absolute(file)); }

void reconstructVerb(const ReconstructOptions& options, const Common& common) {
  if (!options.link.empty() && placeOf(options.link) == placeOf(options.mesh))
    throw CLI::ValidationError("--link", "is the file of --output");
  requireNoInput(options.mesh, {options.scan});
  requireNoInput(options.link, {options.scan});
  checkWritable(options.mesh);  // now, not after the work
  if (!options.link.empty()) checkWritable(options.link);
  const ScanSurface surface = reconstructFile(options);
  writeMesh(options.mesh, surface.mesh);
  if (!options.link.empty()) writeSurfaceLink(options.link, surface);
  if (common.json) {
    std::printf("%s", reconstructionJson(surface.summary).c_str());
    return;
  }
  if (common.quiet) return;
  for (const std::string& warning : surface.summary.warnings)
    std::fprintf(stderr, "posture: %s: %s\n", options.scan.c_str(), warning.c_str());
  const ReconstructionSummary& s = surface.summary;
  std::printf("%ld of %d points made a surface of %d vertices and %d faces: %d %s, %d %s%s\n",
              mappedCount(surface.on_mesh),
              s.points,
              s.vertices,
              s.faces,
              s.components,
              s.components == 1 ? "piece" : "pieces",
              s.boundary_loops,
              s.boundary_loops == 1 ? "rim" : "rims",
              s.through_points ? "; the points have no noise and are its vertices" : "");
}

}  // namespace

void addReconstruct(CLI::App& app, Common& common) {
  auto options = std::make_shared<ReconstructOptions>();
  CLI::App* verb = app.add_subcommand(
      "reconstruct", "Lay a surface through the points of SCAN; what was not seen stays open");
  verb->add_option("SCAN", options->scan, "Points: PCD, PLY, XYZ, TXT, CSV or PTS")->required();
  verb->add_option("-o,--output", options->mesh, "The mesh: PLY, OBJ or OFF")
      ->required()
      ->check(endsInOneOf(MESH_ENDINGS));
  verb->add_option("--link", options->link, "Also write each point's place on the mesh, as CSV");
  addSurfaceOption(verb, options->reconstruction.surface);
  verb->callback([options, &common] { reconstructVerb(*options, common); });
}

}  // namespace posture::app
