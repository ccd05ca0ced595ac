// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/atomic_file.h>
#include <posture/io/shape_io.h>
#include <posture/pipeline/segment_shape.h>
#include <posture/report/colors.h>

#include "folder.h"
#include "json_document.h"
#include "motion_json.h"
#include "progress.h"
#include "register_files.h"
#include "result_files.h"
#include "surface_option.h"
#include "verbs.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

struct SegmentOptions {
  fs::path reference, folder;
  std::vector<fs::path> poses;
  SurfaceMethod surface = SurfaceMethod::TANGENT_DELAUNAY;
};

/// The poses that the reference was registered to, and those where the data did not decide.
struct RegisteredPoses {
  std::vector<ShapeFile> files;
  std::vector<RegistrationResult> results;
  std::vector<std::pair<fs::path, std::string>> left_out;  // with the reason
};

RegisteredPoses registerPoses(const SegmentOptions& options,
                              const ShapeFile& reference,
                              std::vector<ShapeFile> files,
                              ProgressBar& bar) {
  RegistrationOptions registration;
  registration.surface = options.surface;
  RegisteredPoses poses;
  const double count = static_cast<double>(files.size());
  for (std::size_t k = 0; k < files.size(); ++k) {
    ShapeFile& pose = files[k];
    RegistrationResult result =
        registerFiles(reference, pose, registration, [&](const StageEvent& event) {
          bar.show(stageTitle(event.attempt, event.stage),
                   (static_cast<double>(k) + event.progress) / count);
        });
    if (result.status == Status::UNDECIDED) {
      poses.left_out.emplace_back(pose.path, result.message);
      continue;
    }
    poses.files.push_back(std::move(pose));
    poses.results.push_back(std::move(result));
  }
  return poses;
}

std::string poseFile(std::size_t k) { return "pose-" + std::to_string(k + 1) + "_segments.ply"; }

Json describe(const SegmentOptions& options,
              const RegisteredPoses& poses,
              const ShapeSegments& segments) {
  constexpr double DEGREES = 180 / 3.14159265358979323846;
  const RigidSegments& parts = segments.parts;
  Json list = Json::array();
  for (int part = 0; part < parts.count; ++part)
    list.push_back({{"part", part},
                    {"vertices", std::count(segments.label.begin(), segments.label.end(), part)}});
  Json motions = Json::array();
  for (std::size_t k = 0; k < poses.files.size(); ++k) {
    Json of_parts = Json::array();
    for (int part = 0; part < parts.count; ++part) {
      of_parts.push_back(toJson(parts.motion[k][part]));
      of_parts.back()["residual"] = segments.residual[k][part];
    }
    motions.push_back({{"file", poses.files[k].path.string()},
                       {"colored", poseFile(k)},
                       {"trust", poses.results[k].trust},
                       {"scale", parts.scale[k]},
                       {"motions", std::move(of_parts)}});
  }
  Json left_out = Json::array();
  for (const auto& [path, reason] : poses.left_out)
    left_out.push_back({{"file", path.string()}, {"reason", reason}});
  return {{"reference", options.reference.string()},
          {"count", parts.count},
          {"least_turn_degrees", parts.least_turn * DEGREES},
          {"parts", std::move(list)},
          {"poses", std::move(motions)},
          {"left_out", std::move(left_out)}};
}

void writeLabels(const fs::path& path, const std::vector<int>& label) {
  AtomicFile file(path);
  file.stream().imbue(std::locale::classic());
  file.stream() << "vertex,part\n";
  for (std::size_t v = 0; v < label.size(); ++v) file.stream() << v << ',' << label[v] << '\n';
  file.commit();
}

/// segments.json last: with it the folder is a result.
void writeFiles(const fs::path& folder,
                const Shape& reference,
                const RegisteredPoses& poses,
                const ShapeSegments& segments,
                const std::string& described) {
  const Colors colors = writeSegments(folder / "segments.ply", reference, segments);
  writeLabels(folder / "segments.csv", segments.label);
  for (std::size_t k = 0; k < poses.files.size(); ++k) {
    const Shape& pose = poses.files[k].shape;
    writeColored(folder / poseFile(k),
                 pose.cloud.points,
                 pose.faces,
                 transferColors(
                     colors, poses.results[k].correspondence, pose, poses.results[k].target_scan));
  }
  writeFile(folder / "segments.json", described);
}

void segmentVerb(const SegmentOptions& options, Common& common) {
  ProgressBar bar(common.quiet);
  bar.show("reading", 0);
  const ShapeFile reference{options.reference, readShape(options.reference)};
  std::vector<ShapeFile> files;
  for (const fs::path& path : options.poses) files.push_back({path, readShape(path)});
  const OutputFolder folder(options.folder);
  std::vector<fs::path> inputs = options.poses;
  inputs.push_back(options.reference);
  requireNoSegmentFiles(options.folder, inputs);
  checkWritable(options.folder / "segments.json");  // now, not after minutes
  const RegisteredPoses poses = registerPoses(options, reference, std::move(files), bar);
  bar.clear();
  if (!poses.left_out.empty()) {
    common.exit_code = EXIT_UNDECIDED;
    const auto& [path, reason] = poses.left_out.front();
    std::fprintf(stderr, "posture: %s: %s\n", path.c_str(), reason.c_str());
  }
  const bool any = !poses.results.empty();
  const ShapeSegments segments =
      any ? segmentShape(reference.shape, poses.results) : ShapeSegments{};
  const std::string described = documentText(describe(options, poses, segments));
  removeSegmentFiles(options.folder);  // no mix of two results
  try {
    if (any) writeFiles(options.folder, reference.shape, poses, segments, described);
  } catch (...) {  // no part of one either
    removeSegmentFiles(options.folder);
    throw;
  }
  if (common.json)
    std::printf("%s", described.c_str());
  else if (any && !common.quiet)
    std::printf("%d %s almost rigidly over %zu %s\n",
                segments.parts.count,
                segments.parts.count == 1 ? "part that moves" : "parts that move",
                poses.files.size(),
                poses.files.size() == 1 ? "pose" : "poses");
}

}  // namespace

void addSegment(CLI::App& app, Common& common) {
  auto options = std::make_shared<SegmentOptions>();
  CLI::App* verb = app.add_subcommand(
      "segment", "Divide REF into the parts that move almost rigidly to all the poses");
  verb->add_option("REF", options->reference, "Mesh or points, as for register")->required();
  verb->add_option("POSE", options->poses, "The same body in other poses: one or more")->required();
  verb->add_option("-o,--output", options->folder, "Folder for the results")->required();
  addSurfaceOption(verb, options->surface);
  verb->callback([options, &common] { segmentVerb(*options, common); });
}

}  // namespace posture::app
