// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_report.h"

#include <posture/evaluation/map_error.h>
#include <posture/io/atomic_file.h>

#include "compare_run.h"
#include "compare_variation.h"
#include "error_plots.h"
#include "folder.h"
#include "result_columns.h"
#include <algorithm>
#include <iterator>

namespace posture::app {
namespace {

constexpr ResultColumn COLUMNS[] = {{"id", "/id"},
                                    {"family", "/family"},
                                    {"kind", "/kind"},
                                    {"variation", "/variation"},
                                    {"method", "/method"},
                                    {"status", "/status"},
                                    {"source_vertices", "/source_vertices"},
                                    {"target_vertices", "/target_vertices"},
                                    {"mapped", "/mapped"},
                                    {"mean_x100", "/errors/mean_x100"},
                                    {"mean_with_misses_x100", "/errors/mean_with_misses_x100"},
                                    {"median_x100", "/errors/median_x100"},
                                    {"percentile_95_x100", "/errors/percentile_95_x100"},
                                    {"true_pairs", "/errors/true_pairs"},
                                    {"mapped_pairs", "/errors/mapped_pairs"},
                                    {"wrong_side", "/mirror/wrong_side"},
                                    {"mean_distance", "/mean_distance"},
                                    {"stretch", "/stretch"},
                                    {"source_near", "/source_near"},
                                    {"target_near", "/target_near"},
                                    {"trust", "/trust"},
                                    {"seconds", "/seconds"},
                                    {"peak_memory_mib", "/peak_memory_mib"},
                                    {"threads", "/threads"},
                                    {"message", "/message"}};

std::string curveFile(const std::string& variation) { return "curves-" + variation + ".svg"; }

/// One curve a method that has one, over what it failed on as well: none of that is below.
std::vector<NamedSeries> curvesOf(const std::vector<Json>& runs, const std::string& variation) {
  const std::vector<double> none_below(curvePlaces().size(), 0.0);
  std::vector<NamedSeries> curves;
  for (const ComparedMethod& method : comparedMethods()) {
    std::vector<Json> chosen;
    for (const Json& run : runs)
      if (run.value("method", "") == method.key && run.value("variation", "") == variation)
        chosen.push_back(missedAll(run) ? Json{{"errors", {{"curve", none_below}}}} : run);
    const std::vector<double> curve = meanCurve(chosen);
    if (!curve.empty()) curves.push_back({method.name, curve});
  }
  return curves;
}

std::string page(const Comparison& comparison, const std::vector<std::string>& curved) {
  std::string page = "# Comparison\n\nposture " POSTURE_VERSION
                     " beside PCL's rigid registrations; how they are set up: "
                     "docs/comparison.md.\n\n";
  for (const std::string& verdict : comparison.verdicts) page += "- " + verdict + "\n";
  page +=
      "\n## Errors and costs\n\n" + toMarkdown(comparison.errors) +
      "\nSource: aligned, as the files are; turned, by 115 degrees and shifted; scaled, turned, a "
      "thousand times as large and its vertices in another order. The rigid methods estimate no "
      "scale. Error: mean over the mapped points of the geodesic distance on the target from the "
      "vertex found to the true vertex, divided by the square root of the target's area, times "
      "100; of the rigid ones the vertex found is the one nearest to the moved point. Mapped: "
      "share of the true pairs that have a counterpart; without a truth, of the source's points. "
      "With misses: the error over all true pairs, one without a counterpart, or with more, "
      "counting as 25, and a run that failed or refused the pair as well; it says which method is "
      "the best one. "
      "Below: share of the true pairs whose error is at most that share of the square root. "
      "Change: the largest change of a pair's error against the aligned source; inf: it had none "
      "there; failed: it has no answer any more. Side: whether the map is nearer to the truth or "
      "to the answer that takes left for right. Converged is what PCL says, of posture that it "
      "calls the pair registered; came to nothing: failed, refused or not run. Seconds include "
      "reading "
      "(median) and memory is the largest of a process.\n";
  for (const std::string& variation : curved)
    page += "\n![Share of points with error below x, source " + variation + "](" +
            curveFile(variation) + ")\n";
  return page + "\n## How the moved source lies on the target\n\n" + toMarkdown(comparison.fits) +
         "\nMeans over the pairs. Distance: of the moved source's points from the nearest of the "
         "target, over the diagonal of the box of its middle 98 %. Stretch: |log| of an edge's "
         "length after and "
         "before; nothing for what moves as a whole. Near: share of the points within one spacing "
         "of the target's points from the other side. A body bent onto another lies near it "
         "whether the map is right or not: without a truth these figures tell how it fits, not "
         "who is right.\n";
}

}  // namespace

std::vector<std::string> comparisonFiles() {
  std::vector<std::string> files{"comparison.csv", "comparison.json", "comparison.md"};
  for (const std::string& variation : variations()) files.push_back(curveFile(variation));
  return files;
}

Json writeComparison(const std::vector<Json>& runs,
                     const Comparison& comparison,
                     const std::filesystem::path& folder) {
  std::vector<std::string> curved;
  for (const std::string& variation : variations()) {
    const std::vector<NamedSeries> curves = curvesOf(runs, variation);
    if (curves.empty()) continue;
    writeFile(folder / curveFile(variation), curvePlot(curves));
    curved.push_back(variation);
  }
  Json summary{{"version", POSTURE_VERSION}, {"verdicts", comparison.verdicts}, {"runs", runs}};
  writeFile(folder / "comparison.csv",
            toCsv(tableOf(runs, {std::begin(COLUMNS), std::end(COLUMNS)})));
  writeFile(folder / "comparison.json", documentText(summary));
  writeFile(folder / "comparison.md", page(comparison, curved));
  for (const std::string& variation : variations())
    if (std::find(curved.begin(), curved.end(), variation) == curved.end())
      removeFrom(folder, curveFile(variation));
  return summary;
}

}  // namespace posture::app
