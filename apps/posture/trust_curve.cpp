// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trust_curve.h"

#include <posture/report/svg_plot.h>

#include <algorithm>
#include <cmath>

namespace posture::app {
namespace {

constexpr double GOOD_BELOW_X100 = 5;

double shareAbove(const TrustCurve& curve, bool good, double threshold) {
  const auto above =
      std::count_if(curve.points.begin(), curve.points.end(), [&](const TrustCurve::Point& p) {
        return p.is_good == good && p.trust >= threshold;
      });
  return static_cast<double>(above) / (good ? curve.good : curve.bad);
}

}  // namespace

double TrustCurve::area() const {
  double sum = 0;
  for (const Point& g : points)
    for (const Point& b : points)
      if (g.is_good && !b.is_good) sum += g.trust > b.trust ? 1 : (g.trust == b.trust ? 0.5 : 0);
  return sum / (static_cast<double>(good) * bad);
}

double TrustCurve::goodAbove(double threshold) const { return shareAbove(*this, true, threshold); }
double TrustCurve::badAbove(double threshold) const { return shareAbove(*this, false, threshold); }

TrustCurve trustCurve(const std::vector<Json>& results) {
  TrustCurve curve;
  for (const Json& result : results) {
    const double trust = numberAt(result, "/trust"), error = numberAt(result, "/errors/mean_x100");
    const bool unrelated = result.value("kind", "") == "unrelated";
    if (!std::isfinite(trust) || (!unrelated && !std::isfinite(error))) continue;
    const bool good = !unrelated && error < GOOD_BELOW_X100;
    ++(good ? curve.good : curve.bad);
    curve.points.push_back({trust, good});
  }
  std::stable_sort(curve.points.begin(), curve.points.end(), [](const auto& a, const auto& b) {
    return a.trust > b.trust;
  });
  return curve;
}

std::string trustPlot(const TrustCurve& curve) {
  LinePlot plot;
  plot.title = "Trust: good and bad maps told apart";
  plot.x = {"share of the bad maps trusted", 0, 1};
  plot.y = {"share of the good maps trusted", 0, 1};
  PlotLine line{"trust", {0}, {0}};
  for (const TrustCurve::Point& p : curve.points) {
    line.x.push_back(curve.badAbove(p.trust));
    line.y.push_back(curve.goodAbove(p.trust));
  }
  plot.lines.push_back(std::move(line));
  return toSvg(plot);
}

}  // namespace posture::app
