// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_document.h"
#include <string>
#include <vector>

namespace posture::app {

struct NamedSeries {
  std::string name;
  std::vector<double> values;  ///< shares in [0, 1]
};

/// The mean of the curves of those results that have errors, each counting alike; empty: none has.
std::vector<double> meanCurve(const std::vector<Json>& results);

/// Error curves sampled at curvePlaces(), as SVG.
std::string curvePlot(const std::vector<NamedSeries>& curves);

/// Shares of points that are 0, 1, 2, ... edges off, as SVG bars; what is 10 or more off is one
/// bar.
std::string histogramPlot(const std::vector<NamedSeries>& histograms);

}  // namespace posture::app
