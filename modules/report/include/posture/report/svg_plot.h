// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace posture {

/// What an axis shows.
struct PlotAxis {
  std::string label;
  double low = std::numeric_limits<double>::quiet_NaN();   ///< NaN: from the data
  double high = std::numeric_limits<double>::quiet_NaN();  ///< NaN: from the data
};

/// A line; points with a coordinate that is not finite leave a gap.
struct PlotLine {
  std::string name;
  std::vector<double> x, y;
};

struct LinePlot {
  std::string title;
  PlotAxis x, y;
  std::vector<PlotLine> lines;
};

/// One bar a category, drawn beside those of the other groups.
struct PlotBars {
  std::string name;
  std::vector<double> heights;  ///< one a category
};

struct BarPlot {
  std::string title;
  std::string x_label;
  PlotAxis y;
  std::vector<std::string> categories;
  std::vector<PlotBars> groups;
};

/// The plot as an SVG 1.1 document of 720 x 440 units, more where the legend needs it. The same
/// plot gives the same bytes. The legend names the lines in their order; a single line has none.
/// \throws std::invalid_argument  x and y of a line, or heights and categories, differ in number.
std::string toSvg(const LinePlot& plot);
std::string toSvg(const BarPlot& plot);

}  // namespace posture
