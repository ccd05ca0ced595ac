// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/deformation/apply_deformation.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>

#include "common/endings.h"
#include "folder.h"
#include "json_document.h"
#include "result_files.h"
#include "verbs.h"
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

struct ApplyOptions {
  fs::path folder, points, output;
};

TriangleMesh readPart(const fs::path& path) {
  if (!fs::exists(path))
    throw InputError(path.string() + ": missing; no complete result of register");
  return readMesh(path).mesh;
}

struct StoredDeformation {
  DeformedSurface surface;
  std::string doubt;  ///< why the data did not decide; empty: they did
};

/// What a folder that `register` wrote says about its deformation.
StoredDeformation readDeformation(const fs::path& folder) {
  const fs::path report_path = folder / "report.json";
  std::ifstream file(report_path);
  const Json report = Json::parse(file, nullptr, false);
  if (!report.is_object() || !report.contains("files"))
    throw InputError(report_path.string() + ": missing or damaged; no complete result of register");
  const auto text = [&](const char* field) {
    const auto found = report.find(field);
    return found != report.end() && found->is_string() ? found->get<std::string>() : "";
  };
  // Without any map the source was left as it was.
  if (report.value("chosen", Json()).is_null())
    throw InputError(report_path.string() + ": has no deformation: " + text("message"));
  const std::string doubt = text("status") == "registered" ? "" : text("message");
  const auto written = [&](const char* surface, const char* shape) {
    return folder / (report["files"].contains(surface) ? surface : shape);
  };
  const fs::path rest_path = written("source_surface.ply", "source_colored.ply");
  const fs::path moved_path = written("registered_surface.ply", "registered.ply");
  const TriangleMesh rest = readPart(rest_path), moved = readPart(moved_path);
  if (rest.vertices.rows() != moved.vertices.rows())
    throw InputError(moved_path.string() + ": does not go with " + rest_path.filename().string());
  try {
    return {joinedSurface(rest, moved.vertices), doubt};
  } catch (const InputError& error) {
    throw InputError(rest_path.string() + ": " + error.what());
  }
}

/// How many points are farther from the box around a surface than its diagonal is long.
Eigen::Index farOff(const Points& points, const Points& surface) {
  const Eigen::RowVector3d low = surface.colwise().minCoeff(), high = surface.colwise().maxCoeff();
  const double size = (high - low).norm();
  return std::count_if(points.rowwise().begin(), points.rowwise().end(), [&](const auto& p) {
    return (p - p.cwiseMax(low).cwiseMin(high)).norm() > size;
  });
}

std::string counted(Eigen::Index points) {
  return std::to_string(points) + (points == 1 ? " point" : " points");
}

void applyVerb(const ApplyOptions& options, Common& common) {
  const auto [stored, doubt] = readDeformation(options.folder);
  Shape shape = readShape(options.points);
  const std::string wrong =
      wrongEnding(options.output, shape.faces.rows() > 0 ? MESH_ENDINGS : CLOUD_ENDINGS);
  if (!wrong.empty()) throw CLI::ValidationError("--output", wrong);
  requireNoPartOfResult(options.folder, options.output);
  requireNoInput(options.output, {options.points});
  checkWritable(options.output);  // now, not after the work
  const std::vector<int> seen = finiteRows(shape.cloud.points);
  const auto count = static_cast<Eigen::Index>(seen.size());
  const Eigen::Index far = farOff(shape.cloud.points(seen, Eigen::all), stored.rest.vertices);
  if (2 * far > count)
    throw InputError(options.points.string() +
                     ": is nowhere near SOURCE: in another unit, or another frame?");
  shape.cloud = applyDeformation(stored, std::move(shape.cloud));
  shape.cloud.sensor.reset();
  shape.cloud.width = 0;  // what is bent is no depth image
  if (shape.faces.rows() > 0)
    writeMesh(options.output, {shape.cloud.points, shape.faces}, shape.cloud.colors);
  else
    writePointCloud(options.output, shape.cloud);
  if (!doubt.empty()) {
    common.exit_code = EXIT_UNDECIDED;
    std::fprintf(stderr, "posture: %s: %s\n", options.folder.c_str(), doubt.c_str());
  }
  if (common.json)
    std::printf("%s", documentText({{"points", count}, {"far", far}}).c_str());
  else if (!common.quiet)
    std::printf("%s moved%s\n",
                counted(count).c_str(),
                far > 0 ? (", " + counted(far) + " of them far from SOURCE").c_str() : "");
}

}  // namespace

void addApply(CLI::App& app, Common& common) {
  auto options = std::make_shared<ApplyOptions>();
  CLI::App* verb = app.add_subcommand(
      "apply", "Take points or a mesh near SOURCE through the deformation that register found");
  verb->add_option("DIR", options->folder, "Folder that register wrote")->required();
  verb->add_option("POINTS", options->points, "Points or a mesh, in the frame and unit of SOURCE")
      ->required();
  verb->add_option("-o,--output",
                   options->output,
                   "The same, moved: PLY, OBJ or OFF for a mesh; PLY, PCD or XYZ for points")
      ->required()
      ->check(endsInOneOf({".ply", ".obj", ".off", ".pcd", ".xyz"}));
  verb->callback([options, &common] { applyVerb(*options, common); });
}

}  // namespace posture::app
