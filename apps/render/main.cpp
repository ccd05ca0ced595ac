// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <vtkObject.h>

#include "common/endings.h"
#include "common/exit.h"
#include "common/in_range.h"
#include "display.h"
#include "sheet.h"
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <string>
#include <system_error>

namespace {

using posture::app::EXIT_INPUT;
using posture::app::EXIT_USAGE;
using posture::app::inRange;
using posture::render::SheetOptions;

struct Arguments {
  SheetOptions sheet;
  std::string output;
  std::string size = "600x600";
  bool no_faces = false;
  bool json = false;
  bool quiet = false;
  int threads = 0;
  unsigned long seed = 0;
};

int fail(const char* message, int exit_code) noexcept {
  return posture::app::fail("posture render", message, exit_code);
}

/// Empty when `text` is WIDTHxHEIGHT, each 32 to 4096.
std::string checkTileSize(const std::string& text) {
  int width = 0, height = 0, end = 0;
  const bool good = text.size() < 12 &&
                    std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &end) == 2 &&
                    end == static_cast<int>(text.size()) && std::min(width, height) >= 32 &&
                    std::max(width, height) <= 4096;
  return good ? "" : "needs WIDTHxHEIGHT, each 32 to 4096 pixels, not " + text;
}

void addOptions(CLI::App& app, Arguments& arguments) {
  SheetOptions& sheet = arguments.sheet;
  app.add_option("FILE", sheet.files, "Meshes and point clouds, one column each")->required();
  app.add_option("-o,--output", arguments.output, "The picture, a PNG file")
      ->required()
      ->check(posture::app::endsInOneOf({".png"}));
  app.add_option("--view",
                 sheet.views,
                 "A row of this view; may be repeated (default: one row, "
                 "from a side chosen from the data)")
      ->check(CLI::IsMember(posture::render::viewNames()))
      ->expected(1)
      ->take_all();
  app.add_option("--up", sheet.up, "The axis that points up in the data")
      ->check(CLI::IsMember({"auto", "x", "y", "z", "-x", "-y", "-z"}))
      ->capture_default_str();
  app.add_option("--columns", sheet.columns, "Start a new line after so many files")
      ->check(inRange(1, 1000));
  app.add_option("--size", arguments.size, "Pixels of a tile")
      ->check(CLI::Validator(checkTileSize, "WxH"))
      ->capture_default_str();
  app.add_flag("--same-scale", sheet.same_scale, "All tiles at one scale (default: each fitted)");
  app.add_flag("--boundary", sheet.style.boundary, "Dark lines along the edges of holes");
  app.add_flag("--no-faces", arguments.no_faces, "Draw meshes as clouds of their vertices");
  app.add_option("--point-size", sheet.style.point_size, "Pixels of a cloud's points")
      ->check(inRange(0.5, 100.0));
  app.add_flag("--json", arguments.json, "Say on stdout what was drawn");
  app.add_flag("-q,--quiet", arguments.quiet, "As everywhere; there is nothing to silence here");
  app.add_option("--threads", arguments.threads, "As everywhere; the picture does not depend on it")
      ->check(inRange(1, 1024));
  app.add_option("--seed", arguments.seed, "As everywhere; there is nothing random here")
      ->check(inRange(0ul, std::numeric_limits<unsigned long>::max()));
}

std::string describe(const posture::render::Sheet& sheet, const std::string& output) {
  nlohmann::ordered_json json = {
      {"picture", output}, {"width", sheet.image.width}, {"height", sheet.image.height}};
  for (const posture::render::Tile& tile : sheet.tiles)
    json["tiles"].push_back({{"file", tile.file}, {"view", tile.view}, {"covered", tile.coverage}});
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Without the points that are missing.
posture::MeshFile toDraw(posture::Shape shape) {
  posture::PointCloud& cloud = shape.cloud;
  if (shape.faces.rows() > 0) return {{cloud.points, shape.faces}, cloud.normals, cloud.colors};
  const std::vector<int> seen = posture::finiteRows(cloud.points);
  posture::MeshFile file;
  file.mesh.vertices = cloud.points(seen, Eigen::all);
  if (cloud.normals.rows() > 0) file.normals = cloud.normals(seen, Eigen::all);
  if (cloud.colors.rows() > 0) file.colors = cloud.colors(seen, Eigen::all);
  return file;
}

void run(const Arguments& arguments) {
  const SheetOptions& options = arguments.sheet;
  std::vector<posture::MeshFile> shapes;
  for (const auto& file : options.files) {
    if (std::error_code error; std::filesystem::equivalent(file, arguments.output, error))
      throw posture::InputError(file.string() + ": would be written over by the output");
    shapes.push_back(toDraw(posture::readShape(file)));
    if (shapes.back().mesh.vertices.rows() == 0)
      throw posture::InputError(file.string() + ": there is nothing to draw");
  }
  vtkObject::GlobalWarningDisplayOff();
  const posture::render::Display display;
  const posture::render::Sheet sheet = posture::render::drawSheet(shapes, options);
  posture::render::writePng(arguments.output, sheet.image);
  if (arguments.json) std::printf("%s\n", describe(sheet, arguments.output).c_str());
}

int parseAndRun(int argc, char** argv) {
  CLI::App app{
      "Pictures of meshes and point clouds, side by side: one column a file, one row a view."};
  app.name("posture render");
  Arguments arguments;
  addOptions(app, arguments);
  try {
    app.parse(argc, argv);
    arguments.sheet.style.faces = !arguments.no_faces;
    std::sscanf(arguments.size.c_str(), "%dx%d", &arguments.sheet.width, &arguments.sheet.height);
    posture::render::checkSize(arguments.sheet);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return fail((std::string(error.what()) + " (see posture render --help)").c_str(), EXIT_USAGE);
  } catch (const posture::InputError& error) {
    return fail(error.what(), EXIT_USAGE);
  }
  run(arguments);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return fail("stdout cannot be written", EXIT_INPUT);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parseAndRun(argc, argv);
  } catch (const std::bad_alloc&) {
    return fail("the input does not fit into memory", EXIT_INPUT);
  } catch (const std::exception& error) {
    return fail(error.what(), EXIT_INPUT);
  }
}
