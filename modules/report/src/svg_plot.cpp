// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/report/svg_plot.h>

#include "markup.h"
#include "svg_canvas.h"
#include <cmath>

namespace posture {
namespace {

std::vector<double> allOf(const std::vector<PlotLine>& lines,
                          std::vector<double> PlotLine::*member) {
  std::vector<double> values;
  for (const PlotLine& line : lines)
    values.insert(values.end(), (line.*member).begin(), (line.*member).end());
  return values;
}

struct Scales {
  AxisScale x, y;
};

/// "M.. L.." through the points, begun anew behind every gap.
std::string pathOf(const PlotLine& line, const Scales& scales, const SvgCanvas& canvas) {
  std::string path;
  bool pen_down = false;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const bool visible = std::isfinite(line.x[i]) && std::isfinite(line.y[i]);
    if (visible)
      path += (pen_down ? "L" : "M") + coordinate(canvas.toX(scales.x.share(line.x[i]))) + " " +
              coordinate(canvas.toY(scales.y.share(line.y[i])));
    pen_down = visible;
  }
  return path;
}

void addLine(const PlotLine& line, std::size_t index, const Scales& scales, SvgCanvas& canvas) {
  const std::string color = SvgCanvas::color(index);
  const std::string path = pathOf(line, scales, canvas);
  if (!path.empty())
    canvas.add("<path clip-path=\"url(#plot)\" d=\"" + path + "\" fill=\"none\" stroke=\"" + color +
               "\" stroke-width=\"2\" stroke-linejoin=\"round\"/>");
}

/// Lines that leave the axes' range end at the frame.
void addClip(SvgCanvas& canvas) {
  canvas.add("<clipPath id=\"plot\"><rect x=\"" + coordinate(canvas.left()) + "\" y=\"" +
             coordinate(canvas.top() - 2) + "\" width=\"" +
             coordinate(canvas.right() - canvas.left()) + "\" height=\"" +
             coordinate(canvas.bottom() - canvas.top() + 4) + "\"/></clipPath>");
}

}  // namespace

std::string toSvg(const LinePlot& plot) {
  std::vector<std::string> names;
  for (const PlotLine& line : plot.lines) {
    require(line.x.size() == line.y.size(), "line " + line.name + " has more x than y, or fewer");
    names.push_back(line.name);
  }
  const Scales scales{scaleFor(plot.x, allOf(plot.lines, &PlotLine::x)),
                      scaleFor(plot.y, allOf(plot.lines, &PlotLine::y))};
  SvgCanvas canvas(plot.title, names);
  addClip(canvas);
  canvas.addVerticalScale(scales.y, plot.y.label);
  canvas.addHorizontalScale(scales.x, plot.x.label);
  for (std::size_t k = 0; k < plot.lines.size(); ++k) addLine(plot.lines[k], k, scales, canvas);
  return canvas.finish(true);
}

std::string toSvg(const BarPlot& plot) {
  std::vector<std::string> names;
  std::vector<double> heights = {0};
  for (const PlotBars& group : plot.groups) {
    require(group.heights.size() == plot.categories.size(),
            "bars " + group.name + " are not one a category");
    names.push_back(group.name);
    heights.insert(heights.end(), group.heights.begin(), group.heights.end());
  }
  const AxisScale scale = scaleFor(plot.y, heights);
  SvgCanvas canvas(plot.title, names);
  addClip(canvas);
  canvas.addVerticalScale(scale, plot.y.label);
  canvas.addCategories(plot.categories, plot.x_label);
  const double room = 1 / double(std::max<std::size_t>(plot.categories.size(), 1));
  const double width = 0.8 * room / double(std::max<std::size_t>(plot.groups.size(), 1));
  for (std::size_t g = 0; g < plot.groups.size(); ++g)
    for (std::size_t c = 0; c < plot.categories.size(); ++c) {
      const double height = plot.groups[g].heights[c];
      if (!std::isfinite(height)) continue;
      const double x = canvas.toX((double(c) + 0.1) * room + double(g) * width);
      const double end = canvas.toY(scale.share(height)), base = canvas.toY(scale.share(0));
      canvas.add("<rect clip-path=\"url(#plot)\" x=\"" + coordinate(x) + "\" y=\"" +
                 coordinate(std::min(end, base)) + "\" width=\"" +
                 coordinate(width * (canvas.right() - canvas.left())) + "\" height=\"" +
                 coordinate(std::abs(base - end)) + "\" fill=\"" + SvgCanvas::color(g) + "\"/>");
    }
  return canvas.finish(false);
}

}  // namespace posture
