// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/io/atomic_file.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>
#include <posture/synthesis/articulated_body.h>
#include <posture/synthesis/rigid_pair.h>
#include <posture/synthesis/simulated_scan.h>

#include <nlohmann/json.hpp>

#include "common/in_range.h"
#include "folder.h"
#include "motion_json.h"
#include "verbs.h"
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <locale>
#include <memory>
#include <optional>
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
  bool rigid = false;
  bool scan = false;
  ScanOptions scanner;
};

/// One shape as it is asked for and as it came out.
struct Shape {
  std::string name;
  BodyOptions options;
  ArticulatedBody body;
  std::optional<SimulatedScan> scan;

  std::string meshFile() const { return name + ".ply"; }
  std::string bonesFile() const { return name + "-bones.csv"; }
  std::string scanFile() const { return name + "-scan.pcd"; }
  std::string scanSurfaceFile() const { return name + "-scan-surface.txt"; }
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

/// In its own frame: another one than that of every other pose and tessellation.
SimulatedScan makeScan(const SynthesizeOptions& options, const Shape& shape) {
  ScanOptions scanner = options.scanner;
  Rng mix(options.body.seed);
  Rng mix_pose(mix.next() + static_cast<std::uint64_t>(shape.options.pose));
  Rng mix_tessellation(mix_pose.next() + static_cast<std::uint64_t>(shape.options.tessellation));
  scanner.seed = mix_tessellation.next();
  return scanBody(shape.body, scanner);
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
    if (options.scan) shape.scan = makeScan(options, shape);
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

/// Where the points of a scan lie on its surface: rows `point vertex`.
std::vector<VertexPair> surfaceVertices(const SimulatedScan& scan) {
  std::vector<VertexPair> pairs;
  for (std::size_t i = 0; i < scan.vertex.size(); ++i)
    if (scan.vertex[i] >= 0) pairs.push_back({static_cast<int>(i), scan.vertex[i]});
  return pairs;
}

class PairList {
 public:
  PairList(fs::path folder, bool scans) : folder_(std::move(folder)), scans_(scans) {}

  /// Writes the truth files of the pair; returns it as JSON.
  Json add(const std::string& family, const Shape& source, const Shape& target) {
    const std::string id = source.name + "-pose" + std::to_string(target.options.pose);
    return add({id, family, pairKind(source.options), source.meshFile(), target.meshFile()},
               groundTruth(source.body, target.body),
               mirrorTruth(source.body, target.body),
               describe(source, target));
  }

  /// The same for a body that holds still.
  Json addRigid(const std::string& family, const Shape& source, const Shape& target) {
    return add({family + "-rigid", family, "rigid", source.meshFile(), target.meshFile()},
               groundTruth(source.body, target.body),
               mirrorTruth(source.body, target.body),
               describe(source, target) + "; moved as a whole");
  }

  /// The same for the scans of the two.
  Json addScans(const std::string& family, const Shape& source, const Shape& target) {
    const std::string id = source.name + "-pose" + std::to_string(target.options.pose) + "-scan";
    return add({id, family, "scan", source.scanFile(), target.scanFile()},
               groundTruth(*source.scan, *target.scan),
               mirrorTruth(*source.scan, *target.scan),
               describe(source, target),
               {target.meshFile(), target.scanSurfaceFile()});
  }

  void write() const {
    const std::string more = scans_ ? ",target_surface,target_surface_vertices" : "";
    writeText(folder_ / "pairs.csv",
              "id,family,kind,source,target,truth,mirror_truth,note" + more + "\n" + rows_);
  }

 private:
  struct Surface {
    std::string mesh, vertices;
  };

  /// `fields`: id, family, kind, source, target.
  Json add(const std::vector<std::string>& fields,
           const std::vector<VertexPair>& truth,
           const std::vector<VertexPair>& mirror_truth,
           const std::string& note,
           const Surface& surface = {}) {
    const std::string& id = fields.front();
    const std::string file = id + ".txt", mirror_file = id + "-mirror.txt";
    writeVertexPairs(folder_ / file, truth);
    writeVertexPairs(folder_ / mirror_file, mirror_truth);
    for (const std::string& field : fields) rows_ += field + ",";
    rows_ += file + "," + mirror_file + "," + note;
    if (scans_) rows_ += "," + surface.mesh + "," + surface.vertices;
    rows_ += "\n";
    return {
        {"id", id}, {"truth", file}, {"mirror_truth", mirror_file}, {"true_pairs", truth.size()}};
  }

  fs::path folder_;
  bool scans_;
  std::string rows_;
};

/// The bone of each vertex.
void writeBones(const fs::path& path, const ArticulatedBody& body) {
  AtomicFile file(path);
  file.stream().imbue(std::locale::classic());
  file.stream() << "vertex,bone,weight\n";
  for (std::size_t v = 0; v < body.bone.size(); ++v)
    file.stream() << v << ',' << body.bone_names[body.bone[v]] << ','
                  << body.bone_weight[static_cast<Eigen::Index>(v)] << '\n';
  file.commit();
}

/// How the bones move from the rest pose.
Json describeBones(const ArticulatedBody& body) {
  Json bones = Json::array();
  for (std::size_t b = 0; b < body.bone_names.size(); ++b) {
    Json bone{{"bone", body.bone_names[b]}};
    bone.update(toJson(body.bone_motion[b]));
    bones.push_back(std::move(bone));
  }
  return bones;
}

/// Writes the shape, and with it its scan; returns what was written as JSON.
Json writeShape(const fs::path& folder, const Shape& shape, bool quiet) {
  const std::string file = shape.meshFile();
  const TriangleMesh& mesh = shape.scan ? shape.scan->surface : shape.body.mesh;
  const auto vertices = static_cast<long>(mesh.vertices.rows());
  const auto faces = static_cast<long>(mesh.faces.rows());
  writeMesh(folder / file, mesh);
  if (!quiet) std::fprintf(stderr, "%s: %ld vertices, %ld faces\n", file.c_str(), vertices, faces);
  Json json{{"file", file}, {"vertices", vertices}, {"faces", faces}};
  if (!shape.scan) return json;
  writePointCloud(folder / shape.scanFile(), shape.scan->cloud);
  writeVertexPairs(folder / shape.scanSurfaceFile(), surfaceVertices(*shape.scan));
  const auto points =
      static_cast<long>(shape.scan->cloud.points.rowwise().sum().array().isFinite().count());
  if (!quiet) std::fprintf(stderr, "%s: %ld points\n", shape.scanFile().c_str(), points);
  json["scan"] = {{"file", shape.scanFile()},
                  {"points", points},
                  {"surface_vertices", shape.scanSurfaceFile()}};
  return json;
}

/// Two scans of the first pose, the body moved in between.
void synthesizeRigid(const SynthesizeOptions& options, const Common& common) {
  if (options.tessellations.size() > 1)
    throw CLI::ValidationError("--rigid", "takes one --tessellation, the source's");
  makeFolder(options.folder);
  Shape source, target;
  source.options = target.options = options.body;
  source.options.pose = target.options.pose = options.poses.front();
  source.options.tessellation = options.tessellations.front();
  target.options.tessellation = source.options.tessellation + 1;
  RigidPair made = [&] {
    try {
      return makeRigidPair(source.options);
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError("--rigid", error.what());
    }
  }();
  source.body = std::move(made.source);
  target.body = std::move(made.target);
  source.name = options.kind + "-rigid-source";
  target.name = options.kind + "-rigid-target";
  const Json shapes = Json::array({writeShape(options.folder, source, common.quiet),
                                   writeShape(options.folder, target, common.quiet)});
  PairList list(options.folder, false);
  const Json pair = list.addRigid(options.kind, source, target);
  list.write();
  if (common.json)
    std::cout << Json{{"shapes", shapes}, {"pairs", Json::array({pair})}}.dump(1) << '\n';
}

void synthesize(const SynthesizeOptions& options, const Common& common) {
  if (options.rigid) return synthesizeRigid(options, common);
  checkTogether(options);
  makeFolder(options.folder);
  Json shapes = Json::array(), pairs = Json::array();
  PairList list(options.folder, options.scan);
  Json bones = Json::object();
  Shape reference;
  for (std::size_t i = 0; i < options.poses.size(); ++i) {
    Shape shape = makeShape(options, i);
    shapes.push_back(writeShape(options.folder, shape, common.quiet));
    if (!options.scan) {  // a scan has a frame and unit of its own
      writeBones(options.folder / shape.bonesFile(), shape.body);
      bones[shape.meshFile()] = describeBones(shape.body);
      shapes.back()["bones"] = shape.bonesFile();
    }
    if (i == 0) {
      reference = std::move(shape);
      continue;
    }
    pairs.push_back(list.add(options.kind, reference, shape));
    if (options.scan) pairs.push_back(list.addScans(options.kind, reference, shape));
  }
  if (!pairs.empty()) list.write();
  if (!bones.empty()) writeText(options.folder / "bones.json", bones.dump(1) + "\n");
  if (common.json) std::cout << Json{{"shapes", shapes}, {"pairs", pairs}}.dump(1) << '\n';
}

/// Returns --scan, which the others need.
CLI::Option* addScanOptions(CLI::App& verb, SynthesizeOptions& options) {
  CLI::Option* const scan =
      verb.add_flag("--scan", options.scan, "Also scan each pose with simulated depth cameras");
  verb.add_option("--views",
                  options.scanner.views,
                  "Depth images merged into a scan; 1: a single one, kept as a grid")
      ->check(inRange(1, 100))
      ->capture_default_str()
      ->needs(scan);
  verb.add_option("--points", options.scanner.points, "About so many points in a scan")
      ->check(inRange(1000, 5'000'000))
      ->capture_default_str()
      ->needs(scan);
  verb.add_option("--scan-noise",
                  options.scanner.noise,
                  "Scales all errors of the cameras; 0: none, 1: a consumer's")
      ->check(inRange(0.0, 100.0))
      ->capture_default_str()
      ->needs(scan);
  return scan;
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
      ->check(inRange(0, 1'000'000))
      ->capture_default_str();
  CLI::Option* const vertices =
      verb->add_option("--vertices", body.vertices, "About so many vertices, before holes are cut")
          ->check(inRange(1000, 500'000))
          ->default_str("5000; 20000 with --scan");
  verb->add_option("--tessellation",
                   options->tessellations,
                   "Number of the tessellation, or one number a pose; each is another mesh")
      ->check(inRange(0, 1'000'000))
      ->capture_default_str();
  CLI::Option* const remesh = verb->add_flag("--remesh", options->remesh, "Mesh each pose anew");
  verb->add_option("--holes", body.holes, "Holes to cut into each shape")
      ->check(inRange(0, 10'000))
      ->capture_default_str();
  verb->add_option("--hole-radius", body.hole_radius, "Along the surface; the body is about 1 long")
      ->check(inRange(0.0, 1.0))
      ->capture_default_str();
  CLI::Option* const noise =
      verb->add_option(
              "--noise", body.noise, "Standard deviation along the normal, in the same unit")
          ->check(inRange(0.0, 1.0))
          ->capture_default_str();
  CLI::Option* const scan = addScanOptions(*verb, *options);
  scan->excludes(noise);
  verb->add_flag("--rigid",
                 options->rigid,
                 "Instead: the first pose scanned twice, moved a little as a whole in between, "
                 "each time without another end")
      ->excludes(scan)
      ->excludes(remesh);
  verb->callback([options, vertices, &common] {
    // A scan is judged on this mesh, which must not be coarser than the scan.
    if (options->scan && vertices->count() == 0) options->body.vertices = 20'000;
    options->body.kind = options->kind == "human" ? BodyKind::HUMAN : BodyKind::QUADRUPED;
    options->body.seed = common.seed;
    synthesize(*options, common);
  });
}

}  // namespace posture::app
