// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "svg_canvas.h"

#include <posture/report/table.h>

#include "markup.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace posture {
namespace {

constexpr double WIDTH = 720, HEIGHT = 440;
constexpr double LEFT = 72, RIGHT = 24, TOP = 44, BOTTOM = 60;
constexpr double LEGEND_LINE = 20, LEGEND_MARK = 34;
constexpr double LETTER = 6.6;  // mean width at 12 units

double legendWidth(const std::vector<std::string>& legend) {
  if (legend.size() < 2) return 0;
  std::size_t longest = 0;
  for (const std::string& name : legend) longest = std::max(longest, name.size());
  return LEGEND_MARK + LETTER * double(longest) + 14;
}

/// 1, 2 or 5 times a power of ten, about a fifth of `span`.
double roundStep(double span) {
  const double raw = span / 5;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power * 1.0001) return factor * power;
  return 10 * power;
}

std::string tickText(double tick, const AxisScale& scale) {
  const double largest = std::max(std::abs(scale.low), std::abs(scale.high));
  if (scale.decimals > 4 || largest >= 1e7) return formatShort(tick == 0 ? 0 : tick, 4);
  return formatFixed(tick == 0 ? 0 : tick, scale.decimals);
}

}  // namespace

AxisScale scaleFor(const PlotAxis& axis, const std::vector<double>& values) {
  double low = axis.low, high = axis.high;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!std::isfinite(axis.low)) low = std::isfinite(low) ? std::min(low, value) : value;
    if (!std::isfinite(axis.high)) high = std::isfinite(high) ? std::max(high, value) : value;
  }
  if (!std::isfinite(low)) low = std::isfinite(high) ? std::min(0.0, high - 1) : 0;
  if (!std::isfinite(high)) high = low + 1;
  if (!(high > low)) high = low + std::max(1.0, std::abs(low));

  AxisScale scale;
  const double step = roundStep(high - low);
  const auto first = std::floor(low / step + 1e-9), last = std::ceil(high / step - 1e-9);
  scale.low = std::isfinite(axis.low) ? low : first * step;
  scale.high = std::isfinite(axis.high) ? high : last * step;
  for (double k = first; k <= last; ++k)
    if (k * step >= scale.low - 1e-9 * step && k * step <= scale.high + 1e-9 * step)
      scale.ticks.push_back(k * step);
  scale.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return scale;
}

SvgCanvas::SvgCanvas(const std::string& title, std::vector<std::string> legend)
    : legend_(std::move(legend)),
      width_(WIDTH + legendWidth(legend_)),
      height_(std::max(HEIGHT, TOP + BOTTOM + LEGEND_LINE * double(legend_.size()))) {
  addText((left() + right()) / 2, 26, "font-size=\"15\" text-anchor=\"middle\"", title);
}

double SvgCanvas::left() const { return LEFT; }
double SvgCanvas::right() const { return WIDTH - RIGHT; }
double SvgCanvas::top() const { return TOP; }
double SvgCanvas::bottom() const { return height_ - BOTTOM; }

std::string SvgCanvas::color(std::size_t index) {
  // Okabe and Ito's colours: told apart by the colour-blind, too.
  static const std::array<const char*, 7> COLORS = {
      "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};
  return COLORS[index % COLORS.size()];
}

void SvgCanvas::addText(double x, double y, const std::string& style, const std::string& text) {
  add("<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" " + style + ">" +
      escapedMarkup(text) + "</text>");
}

void SvgCanvas::addVerticalScale(const AxisScale& scale, const std::string& label) {
  for (const double tick : scale.ticks) {
    const double y = toY(scale.share(tick));
    add("<path class=\"grid\" d=\"M" + coordinate(left()) + " " + coordinate(y) + "H" +
        coordinate(right()) + "\"/>");
    addText(left() - 8, y + 4, "text-anchor=\"end\"", tickText(tick, scale));
  }
  const std::string middle = coordinate((top() + bottom()) / 2);
  add("<text transform=\"translate(18 " + middle + ") rotate(-90)\" text-anchor=\"middle\">" +
      escapedMarkup(label) + "</text>");
}

void SvgCanvas::addHorizontalScale(const AxisScale& scale, const std::string& label) {
  for (const double tick : scale.ticks) {
    const double x = toX(scale.share(tick));
    add("<path class=\"grid\" d=\"M" + coordinate(x) + " " + coordinate(top()) + "V" +
        coordinate(bottom()) + "\"/>");
    addText(x, bottom() + 18, "text-anchor=\"middle\"", tickText(tick, scale));
  }
  addHorizontalLabel(label);
}

void SvgCanvas::addCategories(const std::vector<std::string>& categories,
                              const std::string& label) {
  const double count = double(categories.size());
  double longest = 1;
  for (const std::string& category : categories)
    longest = std::max(longest, double(category.size()));
  // Every so many, where all do not fit.
  const double room = (right() - left()) / std::max(count, 1.0);
  const auto every =
      static_cast<std::size_t>(std::max(1.0, std::ceil((LETTER * longest + 6) / room)));
  for (std::size_t k = 0; k < categories.size(); k += every)
    addText(toX((double(k) + 0.5) / count), bottom() + 18, "text-anchor=\"middle\"", categories[k]);
  addHorizontalLabel(label);
}

void SvgCanvas::addHorizontalLabel(const std::string& label) {
  addText((left() + right()) / 2, bottom() + 42, "text-anchor=\"middle\"", label);
}

std::string SvgCanvas::finish(bool legend_of_lines) {
  add("<path d=\"M" + coordinate(left()) + " " + coordinate(top()) + "V" + coordinate(bottom()) +
      "H" + coordinate(right()) + "\" fill=\"none\" stroke=\"#333\"/>");
  for (std::size_t k = 0; legend_.size() > 1 && k < legend_.size(); ++k) {
    const double x = right() + 16, y = top() + LEGEND_LINE * (double(k) + 0.5);
    std::string mark = "<path d=\"M" + coordinate(x) + " " + coordinate(y) + "h24\" stroke=\"";
    mark += color(k);
    mark += legend_of_lines ? "\" stroke-width=\"2\"" : "\" stroke-width=\"12\"";
    add(mark + "/>");
    addText(x + LEGEND_MARK, y + 4, "", legend_[k]);
  }
  const std::string size = coordinate(width_) + "\" height=\"" + coordinate(height_);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" +
         size + "\" viewBox=\"0 0 " + coordinate(width_) + " " + coordinate(height_) +
         "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#333\">\n"
         "<style>.grid{stroke:#ddd;fill:none}</style>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
         body_ + "</svg>\n";
}

}  // namespace posture
