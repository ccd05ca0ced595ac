// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/statistics.h>

#include "benchmark_report.h"
#include "error_plots.h"
#include <algorithm>
#include <cmath>
#include <map>

namespace posture::app {
namespace {

int countTrue(const std::vector<Json>& results, const std::string& pointer) {
  const Json::json_pointer place(pointer);
  return static_cast<int>(std::count_if(results.begin(), results.end(), [&](const Json& result) {
    return result.contains(place) && result.at(place) == true;
  }));
}

/// Share of the measured points 0, 1, 2, ... edges off, each pair counting alike.
Json meanHistogram(const std::vector<Json>& results) {
  std::vector<double> sum;
  int histograms = 0;
  for (const Json& result : results) {
    const double points = numberAt(result, "/errors/measured_pairs");
    if (!(points > 0)) continue;
    const auto counts = result["errors"]["edge_histogram"].get<std::vector<int>>();
    sum.resize(std::max(sum.size(), counts.size()), 0.0);
    for (std::size_t i = 0; i < counts.size(); ++i) sum[i] += counts[i] / points;
    ++histograms;
  }
  for (double& value : sum) value /= histograms;
  return sum;
}

Json stageMedians(const std::vector<Json>& results) {
  Json medians = Json::object();
  for (const Json& result : results) {
    if (!result.contains("stages")) continue;
    for (const auto& stage : result["stages"].items())
      if (!medians.contains(stage.key()))
        medians[stage.key()] = percentile(figures(results, "/stages/" + stage.key()), 0.5);
  }
  return medians;
}

/// `results` are all of one family.
Json summarizeFamily(const std::string& family, const std::vector<Json>& results) {
  const auto median = [&](const char* pointer) {
    return percentile(figures(results, pointer), 0.5);
  };
  std::vector<double> shares;
  for (const Json& result : results)
    if (result.contains("accepted"))
      shares.push_back(numberAt(result, "/accepted") / numberAt(result, "/source_vertices"));
  const auto run = figures(results, "/seconds").size();
  const auto failed = static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [](const Json& result) {
        return textAt(result, "status") == "failed";
      }));
  return {{"family", family},
          {"pairs", results.size()},
          {"run", run},
          {"failed", failed},
          {"not_run", results.size() - run - failed},
          {"source_vertices", median("/source_vertices")},
          {"samples", median("/samples")},
          {"judged", figures(results, "/errors/mean_x100").size()},
          {"mean_mean_x100", mean(figures(results, "/errors/mean_x100"))},
          {"median_mean_x100", median("/errors/mean_x100")},
          {"largest_mean_x100", largest(figures(results, "/errors/mean_x100"))},
          {"mean_subvertex_x100", mean(figures(results, "/subvertex_mean_x100"))},
          {"compared", figures(results, "/candidates/best_mean_x100").size()},
          {"median_best_x100", median("/candidates/best_mean_x100")},
          {"largest_best_x100", largest(figures(results, "/candidates/best_mean_x100"))},
          {"chose_wrong", countTrue(results, "/candidates/chose_wrong")},
          {"mirror_known", figures(results, "/mirror/mean_to_mirror_x100").size()},
          {"wrong_side", countTrue(results, "/mirror/wrong_side")},
          {"mean_share_accepted", mean(shares)},
          {"median_accepted", median("/accepted")},
          {"median_rejected", median("/rejected")},
          {"median_share_within_two_edges", median("/errors/share_within_two_edges")},
          {"median_seconds", median("/seconds")},
          {"largest_seconds", largest(figures(results, "/seconds"))},
          {"largest_memory_mib", largest(figures(results, "/peak_memory_mib"))},
          {"stages", stageMedians(results)},
          {"curve", meanCurve(results)},
          {"edge_histogram", meanHistogram(results)}};
}

}  // namespace

Json summarizeFamilies(const std::vector<Json>& results) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<Json>> members;
  for (const Json& result : results) {
    const std::string family = result.value("family", "");
    if (members.count(family) == 0) order.push_back(family);
    members[family].push_back(result);
  }
  Json families = Json::array();
  for (const std::string& family : order)
    families.push_back(summarizeFamily(family, members[family]));
  return families;
}

}  // namespace posture::app
