// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/io/atomic_file.h>
#include <posture/synthesis/articulated_body.h>
#include <posture/synthesis/rigid_pair.h>
#include <posture/synthesis/simulated_scan.h>

#include "common/in_range.h"
#include "folder.h"
#include "json_document.h"
#include "synthesize_files.h"
#include "verbs.h"
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

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
SimulatedScan makeScan(const SynthesizeOptions& options, const SynthesizedShape& shape) {
  ScanOptions scanner = options.scanner;
  Rng mix(options.body.seed);
  Rng mix_pose(mix.next() + static_cast<std::uint64_t>(shape.options.pose));
  Rng mix_tessellation(mix_pose.next() + static_cast<std::uint64_t>(shape.options.tessellation));
  scanner.seed = mix_tessellation.next();
  return scanBody(shape.body, scanner);
}

SynthesizedShape makeShape(const SynthesizeOptions& options, std::size_t i) {
  SynthesizedShape shape;
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

/// Two scans of the first pose, the body moved in between.
void synthesizeRigid(const SynthesizeOptions& options, const Common& common) {
  if (options.tessellations.size() > 1)
    throw CLI::ValidationError("--rigid", "takes one --tessellation, the source's");
  const OutputFolder folder(options.folder);
  SynthesizedShape source, target;
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
  PairList list(options.folder, false);
  const Json shapes = Json::array({writeShape(options.folder, source, common.quiet),
                                   writeShape(options.folder, target, common.quiet)});
  const Json pair = list.addRigid(options.kind, source, target);
  list.write();
  if (common.json) std::cout << documentText({{"shapes", shapes}, {"pairs", Json::array({pair})}});
}

void synthesize(const SynthesizeOptions& options, const Common& common) {
  if (options.rigid) return synthesizeRigid(options, common);
  checkTogether(options);
  const OutputFolder folder(options.folder);
  // What cannot be made takes nothing of a run before away.
  const SynthesizedShape reference = makeShape(options, 0);
  removeFrom(options.folder, "bones.json");
  PairList list(options.folder, options.scan);
  Json shapes = Json::array(), pairs = Json::array(), bones = Json::object();
  const auto write = [&](const SynthesizedShape& shape) {
    removeOtherFilesOf(options.folder, shape);
    shapes.push_back(writeShape(options.folder, shape, common.quiet));
    if (options.scan) return;  // a scan has a frame and unit of its own
    writeBones(options.folder / shape.bonesFile(), shape.body);
    bones[shape.meshFile()] = describeBones(shape.body);
    shapes.back()["bones"] = shape.bonesFile();
  };
  write(reference);
  for (std::size_t i = 1; i < options.poses.size(); ++i) {
    const SynthesizedShape shape = makeShape(options, i);
    write(shape);
    pairs.push_back(list.add(options.kind, reference, shape));
    if (options.scan) pairs.push_back(list.addScans(options.kind, reference, shape));
  }
  if (!pairs.empty()) list.write();
  if (!bones.empty()) writeFile(options.folder / "bones.json", documentText(bones));
  if (common.json) std::cout << documentText({{"shapes", shapes}, {"pairs", pairs}});
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
