// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/report/svg_plot.h>

#include <string>
#include <vector>

namespace posture {

/// Round places on an axis, and where it begins and ends.
struct AxisScale {
  double low = 0, high = 1;
  std::vector<double> ticks;
  int decimals = 0;  ///< that the ticks need

  double share(double value) const { return (value - low) / (high - low); }
};

/// Over `values` and what `axis` fixes; ends that are not fixed are moved out to a tick.
AxisScale scaleFor(const PlotAxis& axis, const std::vector<double>& values);

/// The frame of a plot that is being drawn: title, axes, legend.
class SvgCanvas {
 public:
  /// \param legend  names of the lines or bars; fewer than two: no legend.
  SvgCanvas(const std::string& title, std::vector<std::string> legend);

  double left() const;
  double right() const;
  double top() const;
  double bottom() const;
  double toX(double share) const { return left() + share * (right() - left()); }
  double toY(double share) const { return bottom() - share * (bottom() - top()); }

  void addVerticalScale(const AxisScale& scale, const std::string& label);
  void addHorizontalScale(const AxisScale& scale, const std::string& label);
  void addCategories(const std::vector<std::string>& categories, const std::string& label);
  void add(const std::string& element) { body_ += element + "\n"; }

  /// The whole document.
  std::string finish(bool legend_of_lines);

  static std::string color(std::size_t index);

 private:
  void addText(double x, double y, const std::string& style, const std::string& text);
  void addHorizontalLabel(const std::string& label);

  std::vector<std::string> legend_;
  double width_, height_;
  std::string body_;
};

}  // namespace posture
