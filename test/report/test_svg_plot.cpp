// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/svg_plot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <report/markup_checks.h>
#include <stdexcept>

namespace posture {
namespace {

LinePlot curves() {
  LinePlot plot;
  plot.title = "Share of points with error < x & \"more\"";
  plot.x = {"error", 0, 0.25};
  plot.y = {"share", 0, 1};
  for (const double rate : {20.0, 60.0}) {
    PlotLine line;
    line.name = "rate <" + std::to_string(static_cast<int>(rate)) + ">";
    for (int i = 0; i <= 100; ++i) {
      line.x.push_back(0.0025 * i);
      line.y.push_back(1 - std::exp(-rate * line.x.back()));
    }
    plot.lines.push_back(line);
  }
  return plot;
}

TEST(SvgPlot, isWellFormedAndRepeatable) {
  const std::string svg = toSvg(curves());
  EXPECT_EQ(test::markupFault(svg), "");
  EXPECT_EQ(svg, toSvg(curves()));
  EXPECT_NE(svg.find("rate &lt;20&gt;"), std::string::npos);
  EXPECT_NE(svg.find("error &lt; x &amp; &quot;more&quot;"), std::string::npos);
}

TEST(SvgPlot, axesAreTickedAtRoundPlaces) {
  const std::string svg = toSvg(curves());
  for (const char* tick : {">0.00<", ">0.05<", ">0.10<", ">0.25<", ">0.2<", ">1.0<"})
    EXPECT_NE(svg.find(tick), std::string::npos) << tick;
  EXPECT_EQ(svg.find(">0.30<"), std::string::npos);
}

TEST(SvgPlot, gapsWhereValuesAreMissing) {
  LinePlot plot;
  PlotLine line;
  line.x = {1, 2, 3, 4, 5};
  line.y = {1, 2, std::nan(""), 4, INFINITY};
  plot.lines = {line};
  const std::string svg = toSvg(plot);
  EXPECT_EQ(test::markupFault(svg), "");
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(SvgPlot, nothingAndConstantsArePlots) {
  LinePlot plot;
  EXPECT_EQ(test::markupFault(toSvg(plot)), "");
  PlotLine line;
  line.x = {7};
  line.y = {-3};
  plot.lines = {line};
  EXPECT_EQ(test::markupFault(toSvg(plot)), "");
  EXPECT_EQ(test::markupFault(toSvg(BarPlot{})), "");
}

TEST(SvgPlot, bars) {
  BarPlot plot;
  plot.categories = {"0", "1", "2+"};
  plot.groups = {PlotBars{"cats", {0.5, 0.3, 0.2}}, PlotBars{"dogs", {0.1, 0.4, 0.5}}};
  const std::string svg = toSvg(plot);
  EXPECT_EQ(test::markupFault(svg), "");
  EXPECT_EQ(test::countOf(svg, "<rect clip-path"), 6);
  EXPECT_NE(svg.find(">2+<"), std::string::npos);
}

TEST(SvgPlot, misuseThrows) {
  LinePlot plot = curves();
  plot.lines[0].y.pop_back();
  EXPECT_THROW(toSvg(plot), std::invalid_argument);
  BarPlot bars;
  bars.categories = {"a"};
  bars.groups.resize(1);
  EXPECT_THROW(toSvg(bars), std::invalid_argument);
}

}  // namespace
}  // namespace posture
