// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/synthesis/articulated_body.h>

#include <nlohmann/json.hpp>

#include "folder.h"
#include "verbs.h"
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <locale>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>

namespace posture::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct SynthesizeOptions {
  fs::path folder;
  std::string kind = "quadruped";
  std::vector<int> poses = {0, 1};
  std::vector<int> tessellations = {0};
  bool remesh = false;
  BodyOptions body;
};

/// One shape as it is asked for and as it came out.
struct Shape {
  std::string name;
  BodyOptions options;
  ArticulatedBody body;
};

void checkTogether(const SynthesizeOptions& options) {
  const std::set<int> different(options.poses.begin(), options.poses.end());
  if (different.size() != options.poses.size())
    throw CLI::ValidationError("--pose", "the same pose is given twice");
  const std::size_t count = options.tessellations.size();
  if (count != 1 && count != options.poses.size())
    throw CLI::ValidationError("--tessellation",
                               "expected one number, or one for each of the " +
                                   std::to_string(options.poses.size()) + " poses");
  if (options.remesh && count != 1)
    throw CLI::ValidationError("--remesh", "takes one --tessellation, the first pose's");
}

Shape makeShape(const SynthesizeOptions& options, std::size_t i) {
  Shape shape;
  shape.options = options.body;
  shape.options.pose = options.poses[i];
  const auto& given = options.tessellations;
  shape.options.tessellation = given.size() > 1 ? given[i] : given[0];
  if (options.remesh) shape.options.tessellation += static_cast<int>(i);
  shape.name = options.kind + "-pose" + std::to_string(options.poses[i]);
  try {
    shape.body = makeBody(shape.options);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(shape.name, error.what());
  }
  return shape;
}

std::string pairKind(const BodyOptions& body) {
  return body.noise > 0 ? "noise" : body.holes > 0 ? "holes" : "isometric";
}

/// What was asked for, in words without a comma.
std::string describe(const Shape& source, const Shape& target) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const BodyOptions &a = source.options, &b = target.options;
  text << "synthetic; tessellations " << a.tessellation << " and " << b.tessellation;
  if (a.holes > 0) text << "; " << a.holes << " holes of radius " << a.hole_radius << " each";
  if (a.noise > 0) text << "; noise " << a.noise;
  return text.str();
}

class PairList {
 public:
  explicit PairList(fs::path folder) : folder_(std::move(folder)) {}

  /// Writes the truth files of the pair; returns the pair as JSON.
  Json add(const std::string& family, const Shape& source, const Shape& target) {
    const std::string id = source.name + "-pose" + std::to_string(target.options.pose);
    const std::string truth = id + ".txt", mirror = id + "-mirror.txt";
    const std::vector<VertexPair> pairs = groundTruth(source.body, target.body);
    writeVertexPairs(folder_ / truth, pairs);
    writeVertexPairs(folder_ / mirror, mirrorTruth(source.body, target.body));
    rows_ += id + "," + family + "," + pairKind(source.options) + "," + source.name + ".ply," +
             target.name + ".ply," + truth + "," + mirror + "," + describe(source, target) + "\n";
    return {{"id", id}, {"truth", truth}, {"mirror_truth", mirror}, {"true_pairs", pairs.size()}};
  }

  void write() const {
    writeText(folder_ / "pairs.csv",
              "id,family,kind,source,target,truth,mirror_truth,note\n" + rows_);
  }

 private:
  fs::path folder_;
  std::string rows_;
};

void synthesize(const SynthesizeOptions& options, const Common& common) {
  checkTogether(options);
  makeFolder(options.folder);
  Json shapes = Json::array(), pairs = Json::array();
  PairList list(options.folder);
  Shape reference;
  for (std::size_t i = 0; i < options.poses.size(); ++i) {
    Shape shape = makeShape(options, i);
    const std::string file = shape.name + ".ply";
    const auto vertices = static_cast<long>(shape.body.mesh.vertices.rows());
    const auto faces = static_cast<long>(shape.body.mesh.faces.rows());
    writeMesh(options.folder / file, shape.body.mesh);
    if (!common.quiet)
      std::fprintf(stderr, "%s: %ld vertices, %ld faces\n", file.c_str(), vertices, faces);
    shapes.push_back({{"file", file}, {"vertices", vertices}, {"faces", faces}});
    if (i == 0)
      reference = std::move(shape);
    else
      pairs.push_back(list.add(options.kind, reference, shape));
  }
  if (!pairs.empty()) list.write();
  if (common.json) std::cout << Json{{"shapes", shapes}, {"pairs", pairs}}.dump(1) << '\n';
}

}  // namespace

void addSynthesize(CLI::App& app, Common& common) {
  auto options = std::make_shared<SynthesizeOptions>();
  BodyOptions& body = options->body;
  CLI::App* verb = app.add_subcommand(
      "synthesize", "Make an articulated body in several poses, with its true correspondence");
  verb->add_option("-o,--output", options->folder, "Folder for meshes, truth and pairs.csv")
      ->required();
  verb->add_option("--kind", options->kind, "quadruped or human")
      ->check(CLI::IsMember({"quadruped", "human"}))
      ->capture_default_str();
  verb->add_option("--pose",
                   options->poses,
                   "Poses, each paired with the first: 0 rest, 1 to 9 made by hand, others random")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  verb->add_option("--vertices", body.vertices, "About so many vertices, before holes are cut")
      ->check(CLI::Range(1000, 500'000))
      ->capture_default_str();
  verb->add_option("--tessellation",
                   options->tessellations,
                   "Number of the tessellation, or one number a pose; each is another mesh")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  verb->add_flag("--remesh", options->remesh, "Mesh each pose anew");
  verb->add_option("--holes", body.holes, "Holes to cut into each shape")
      ->check(CLI::Range(0, 10'000))
      ->capture_default_str();
  verb->add_option("--hole-radius", body.hole_radius, "Along the surface; the body is about 1 long")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb->add_option("--noise", body.noise, "Standard deviation along the normal, in the same unit")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb->callback([options, &common] {
    options->body.kind = options->kind == "human" ? BodyKind::HUMAN : BodyKind::QUADRUPED;
    options->body.seed = common.seed;
    synthesize(*options, common);
  });
}

}  // namespace posture::app
