// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>
#include <posture/scan/reconstruct.h>

#include <nlohmann/json.hpp>

#include "result_files.h"
#include "surface_option.h"
#include "verbs.h"
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace posture::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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

Json describe(const ReconstructionSummary& s) {
  return {{"points", s.points},
          {"missing", s.missing},
          {"repeated", s.repeated},
          {"outliers", s.outliers},
          {"dropped_pieces", s.dropped_pieces},
          {"spacing", s.spacing},
          {"noise", s.noise},
          {"mesh_spacing", s.mesh_spacing},
          {"averaged", s.averaged},
          {"vertices", s.vertices},
          {"faces", s.faces},
          {"components", s.components},
          {"boundary_loops", s.boundary_loops},
          {"boundary_length", s.boundary_length},
          {"thin_share", s.thin},
          {"contacts", s.contacts},
          {"double_walls", s.double_walls},
          {"oriented_by_sensor", s.oriented_by_sensor},
          {"oriented_by_normals", s.oriented_by_normals},
          {"warnings", s.warnings}};
}

void reconstructVerb(const ReconstructOptions& options, const Common& common) {
  const ScanSurface surface = reconstructFile(options);
  writeMesh(options.mesh, surface.mesh);
  if (!options.link.empty()) writeSurfaceLink(options.link, surface);
  if (common.json) {
    std::cout << describe(surface.summary).dump(1) << '\n';
    return;
  }
  if (common.quiet) return;
  for (const std::string& warning : surface.summary.warnings)
    std::fprintf(stderr, "posture: %s: %s\n", options.scan.c_str(), warning.c_str());
  const ReconstructionSummary& s = surface.summary;
  std::printf("%d of %d points made a surface of %d vertices and %d faces: %d %s, %d %s\n",
              s.points - s.missing - s.outliers,
              s.points,
              s.vertices,
              s.faces,
              s.components,
              s.components == 1 ? "piece" : "pieces",
              s.boundary_loops,
              s.boundary_loops == 1 ? "rim" : "rims");
}

}  // namespace

void addReconstruct(CLI::App& app, Common& common) {
  auto options = std::make_shared<ReconstructOptions>();
  CLI::App* verb = app.add_subcommand(
      "reconstruct", "Lay a surface through the points of SCAN; what was not seen stays open");
  verb->add_option("SCAN", options->scan, "Points: PCD, PLY, XYZ, TXT or CSV")->required();
  verb->add_option("-o,--output", options->mesh, "The mesh: PLY, OBJ or OFF")->required();
  verb->add_option("--link", options->link, "Also write each point's place on the mesh, as CSV");
  addSurfaceOption(verb, options->reconstruction.surface);
  verb->callback([options, &common] { reconstructVerb(*options, common); });
}

}  // namespace posture::app
