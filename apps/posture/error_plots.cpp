// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "error_plots.h"

#include <posture/evaluation/map_error.h>
#include <posture/report/svg_plot.h>

#include <numeric>

namespace posture::app {
namespace {

constexpr std::size_t LAST_BAR = 10;  ///< edges; more are counted with these

}  // namespace

std::vector<double> meanCurve(const std::vector<Json>& results) {
  std::vector<double> sum;
  int curves = 0;
  for (const Json& result : results) {
    if (!result.contains("errors")) continue;
    const auto curve = result["errors"]["curve"].get<std::vector<double>>();
    sum.resize(curve.size(), 0.0);
    for (std::size_t i = 0; i < curve.size(); ++i) sum[i] += curve[i];
    ++curves;
  }
  for (double& value : sum) value /= curves;
  return sum;
}

std::string curvePlot(const std::vector<NamedSeries>& curves) {
  LinePlot plot;
  plot.title = "Share of points with error below x";
  plot.x = {"geodesic error / square root of the area", 0, 0.25};
  plot.y = {"share of true pairs", 0, 1};
  for (const NamedSeries& curve : curves)
    plot.lines.push_back({curve.name, curvePlaces(), curve.values});
  return toSvg(plot);
}

std::string histogramPlot(const std::vector<NamedSeries>& histograms) {
  BarPlot plot;
  plot.title = "Accepted points by error in edges";
  plot.x_label = "edges from the vertex found to the true one";
  plot.y = {"share of accepted points", 0, 1};
  for (std::size_t edges = 0; edges < LAST_BAR; ++edges)
    plot.categories.push_back(std::to_string(edges));
  plot.categories.push_back(std::to_string(LAST_BAR) + "+");
  for (const NamedSeries& histogram : histograms) {
    PlotBars bars{histogram.name, histogram.values};
    const double more =
        bars.heights.size() > LAST_BAR
            ? std::accumulate(bars.heights.begin() + LAST_BAR, bars.heights.end(), 0.0)
            : 0.0;
    bars.heights.resize(LAST_BAR + 1, 0.0);
    bars.heights[LAST_BAR] = more;
    plot.groups.push_back(std::move(bars));
  }
  return toSvg(plot);
}

}  // namespace posture::app
