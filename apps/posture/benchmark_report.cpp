// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark_report.h"

#include <posture/io/atomic_file.h>

#include "error_plots.h"
#include "folder.h"
#include "result_columns.h"
#include <iterator>

namespace posture::app {
namespace {

constexpr ResultColumn COLUMNS[] = {{"id", "/id"},
                                    {"family", "/family"},
                                    {"kind", "/kind"},
                                    {"method", "/method"},
                                    {"status", "/status"},
                                    {"source_vertices", "/source_vertices"},
                                    {"target_vertices", "/target_vertices"},
                                    {"samples", "/samples"},
                                    {"mean_x100", "/errors/mean_x100"},
                                    {"subvertex_mean_x100", "/subvertex_mean_x100"},
                                    {"median_x100", "/errors/median_x100"},
                                    {"percentile_95_x100", "/errors/percentile_95_x100"},
                                    {"true_pairs", "/errors/true_pairs"},
                                    {"mapped_pairs", "/errors/mapped_pairs"},
                                    {"measured_pairs", "/errors/measured_pairs"},
                                    {"accepted", "/accepted"},
                                    {"rejected", "/rejected"},
                                    {"share_within_two_edges", "/errors/share_within_two_edges"},
                                    {"chosen", "/chosen"},
                                    {"best", "/candidates/best"},
                                    {"chosen_sampled_mean_x100", "/candidates/chosen_mean_x100"},
                                    {"best_sampled_mean_x100", "/candidates/best_mean_x100"},
                                    {"chose_wrong", "/candidates/chose_wrong"},
                                    {"wrong_side", "/mirror/wrong_side"},
                                    {"share_nearer_mirror", "/mirror/share_nearer_mirror"},
                                    {"median_distance_edges", "/fit/median_distance"},
                                    {"percentile_95_distance_edges", "/fit/percentile_95_distance"},
                                    {"mean_stretch", "/fit/mean_stretch"},
                                    {"percentile_95_stretch", "/fit/percentile_95_stretch"},
                                    {"consistency", "/consistency"},
                                    {"trust", "/trust"},
                                    {"score", "/score"},
                                    {"seconds", "/seconds"},
                                    {"peak_memory_mib", "/peak_memory_mib"},
                                    {"threads", "/threads"},
                                    {"message", "/message"}};

/// The families' values under `key`; those that have none are left out.
std::vector<NamedSeries> seriesOf(const Json& families, const char* key) {
  std::vector<NamedSeries> series;
  for (const Json& f : families)
    if (!f[key].empty()) series.push_back({f["family"], f[key].get<std::vector<double>>()});
  return series;
}

}  // namespace

std::vector<std::string> benchmarkReportFiles() {
  return {"results.csv", "results.json", "RESULTS.md", "curves.svg", "histogram.svg", "trust.svg"};
}

Json writeBenchmarkReport(const std::vector<Json>& results,
                          std::size_t listed,
                          const std::filesystem::path& folder) {
  const Json families = summarizeFamilies(results);
  const TrustCurve trust = trustCurve(results);
  Json summary{
      {"version", POSTURE_VERSION},
      {"listed", listed},
      {"families", families},
      {"trust",
       {{"good_pairs", trust.good}, {"bad_pairs", trust.bad}, {"area_under_curve", trust.area()}}},
      {"pairs", results}};
  writeFile(folder / "results.csv",
            toCsv(tableOf(results, {std::begin(COLUMNS), std::end(COLUMNS)})));
  writeFile(folder / "results.json", documentText(summary));
  writeFile(folder / "RESULTS.md", benchmarkPage(results, families, trust, listed));
  writeFile(folder / "curves.svg", curvePlot(seriesOf(families, "curve")));
  writeFile(folder / "histogram.svg", histogramPlot(seriesOf(families, "edge_histogram")));
  if (trust.isKnown())
    writeFile(folder / "trust.svg", trustPlot(trust));
  else
    removeFrom(folder, "trust.svg");
  return summary;
}

}  // namespace posture::app
