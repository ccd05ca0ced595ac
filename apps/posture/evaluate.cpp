// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/evaluation/truth.h>
#include <posture/io/atomic_file.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/shape_io.h>
#include <posture/mesh/seams.h>
#include <posture/report/table.h>

#include "error_json.h"
#include "error_plots.h"
#include "folder.h"
#include "judge_map.h"
#include "target_places.h"
#include "verbs.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

struct EvaluateOptions {
  fs::path map, truth, target, mirror, surface, surface_vertices, folder;
};

/// A cloud's places have faces of a surface that is not at hand: their points are checked alone.
void checkMap(const EvaluateOptions& options, const Shape& target, std::vector<SurfacePoint> map) {
  if (target.faces.rows() == 0)
    for (SurfacePoint& place : map) place.face = -1;
  TriangleMesh mesh{target.cloud.points, target.faces};
  if (mesh.faces.rows() > 0) closeSeams(mesh);  // as when it was registered
  checkOnTarget(options.map.string(), map, mesh);
}

Json measure(const EvaluateOptions& options) {
  const Shape target = readShape(options.target);
  const std::vector<SurfacePoint> map = readCorrespondence(options.map).on_target;
  checkMap(options, target, map);
  const int n = static_cast<int>(map.size()), m = static_cast<int>(target.cloud.points.rows());
  const auto read = [&](const fs::path& pairs) {
    try {
      return readTruth(pairs, n, m);
    } catch (const InputError& error) {
      if (pairs != "identity") throw;  // or is it the map that is not whole?
      throw InputError(std::string(error.what()) + "; rows of " + options.map.string() + ": " +
                       std::to_string(n));
    }
  };
  const std::vector<VertexPair> truth = read(options.truth);
  std::vector<VertexPair> mirror_truth;
  if (!options.mirror.empty()) mirror_truth = read(options.mirror);

  const TargetPlaces places =
      options.surface.empty()
          ? TargetPlaces(options.target, target, std::nullopt)
          : TargetPlaces(options.target, target, options.surface, options.surface_vertices, truth);
  Json judged = judgeMap(places, places.metric(), map, truth, mirror_truth);
  Json json = std::move(judged["errors"]);
  judged.erase("errors");
  json.update(judged);
  return json;
}

void printFigures(const Json& json) {
  const auto count = [&](const char* key) { return json[key].get<int>(); };
  std::printf("mean error x100        %s\n", formatFixed(numberAt(json, "/mean_x100"), 3).c_str());
  std::printf("median x100            %s\n",
              formatFixed(numberAt(json, "/median_x100"), 3).c_str());
  std::printf("95th percentile x100   %s\n",
              formatFixed(numberAt(json, "/percentile_95_x100"), 3).c_str());
  std::printf("mean x100 in faces     %s\n",
              formatFixed(numberAt(json, "/subvertex_mean_x100"), 3).c_str());
  for (double place : {0.01, 0.02, 0.05, 0.1, 0.25})
    std::printf("error below %-4g       %s\n", place, formatPercent(curveAt(json, place)).c_str());
  std::printf("accepted               %d of %d (%s), %d rejected\n",
              count("accepted"),
              count("source_vertices"),
              formatPercent(json["share_accepted"]).c_str(),
              count("rejected"));
  std::printf("true pairs             %d, mapped %d, measured %d\n",
              count("true_pairs"),
              count("mapped_pairs"),
              count("measured_pairs"));
  std::printf("within two edges       %s\n",
              formatPercent(numberAt(json, "/share_within_two_edges")).c_str());
  std::printf("points by edges off   ");
  const auto histogram = json["edge_histogram"].get<std::vector<int>>();
  for (std::size_t edges = 0; edges < std::min<std::size_t>(histogram.size(), 10); ++edges)
    std::printf(" %zu:%d", edges, histogram[edges]);
  std::printf("%s\n", histogram.size() > 10 ? " ..." : "");
  if (!json.contains("mirror")) return;
  const Json& mirror = json["mirror"];
  std::printf(
      "side                   %s (mean x100 to the truth %s, to its mirror image %s; %s "
      "nearer to the mirror image)\n",
      mirror["wrong_side"] == true ? "wrong" : "right",
      formatFixed(numberAt(mirror, "/mean_to_truth_x100"), 3).c_str(),
      formatFixed(numberAt(mirror, "/mean_to_mirror_x100"), 3).c_str(),
      formatPercent(mirror["share_nearer_mirror"]).c_str());
}

void writeFigures(const fs::path& folder, const Json& json) {
  writeFile(folder / "evaluation.json", documentText(json));
  const auto curve = json["curve"].get<std::vector<double>>();
  const std::vector<double> places = curvePlaces();
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < curve.size(); ++i)
    rows.push_back({formatFixed(places[i], 4), formatFixed(curve[i], 6)});
  writeFile(folder / "curve.csv", toCsv({{"error", "share_below"}, rows}));
  std::vector<double> shares;
  for (int points : json["edge_histogram"].get<std::vector<int>>())
    shares.push_back(points / json["measured_pairs"].get<double>());
  writeFile(folder / "curve.svg", curvePlot({{"map", curve}}));
  writeFile(folder / "histogram.svg", histogramPlot({{"map", shares}}));
}

void evaluate(const EvaluateOptions& options, const Common& common) {
  std::optional<OutputFolder> folder;
  if (!options.folder.empty()) {
    folder.emplace(options.folder);
    const std::vector<std::string> files{
        "evaluation.json", "curve.csv", "curve.svg", "histogram.svg"};
    requireNoInput(options.folder,
                   files,
                   {options.map,
                    options.truth,
                    options.target,
                    options.mirror,
                    options.surface,
                    options.surface_vertices});
    for (const std::string& file : files) checkWritable(options.folder / file);
  }
  const Json json = measure(options);
  if (!options.folder.empty()) writeFigures(options.folder, json);
  if (common.json)
    std::cout << documentText(json);
  else if (!common.quiet)
    printFigures(json);
}

}  // namespace

void addEvaluate(CLI::App& app, Common& common) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* verb = app.add_subcommand("evaluate", "Say how far a correspondence is from the truth");
  verb->add_option("CORRESPONDENCE", options->map, "correspondence.csv as register writes it")
      ->required();
  verb->add_option("--truth", options->truth, "File of `source target` rows, or: identity")
      ->required();
  verb->add_option("--target", options->target, "The target: mesh or points")->required();
  CLI::Option* surface =
      verb->add_option("--surface",
                       options->surface,
                       "Clean mesh that the target is a scan or a part of, in its frame, to "
                       "measure on (default: the target itself, through points a surface is laid)");
  verb->add_option(
          "--surface-vertices",
          options->surface_vertices,
          "File of `point vertex` rows: where the target's points (vertices) lie on --surface "
          "(default: at the nearest vertex)")
      ->needs(surface);
  verb->add_option("--mirror", options->mirror, "As --truth, for the left-right mirrored answer");
  verb->add_option("-o,--output", options->folder, "Folder for evaluation.json, curves and plots");
  verb->callback([options, &common] { evaluate(*options, common); });
}

}  // namespace posture::app
