// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_document.h"
#include <string>
#include <vector>

namespace posture::app {

/// How well the trust figure tells good maps from bad ones (receiver operating characteristic).
struct TrustCurve {
  struct Point {
    double trust;
    bool is_good;
  };
  std::vector<Point> points;  ///< by decreasing trust
  int good = 0, bad = 0;

  bool isKnown() const { return good > 0 && bad > 0; }
  /// Probability that a good map is trusted more than a bad one, ties counting half.
  double area() const;
  double goodAbove(double threshold) const;  ///< share of the good ones
  double badAbove(double threshold) const;
};

/// A map is good when its mean error is below 0.05 of sqrt(area), and bad when it is not or when
/// the pair is of the kind "unrelated". Pairs that were not run or whose truth is not known do not
/// count.
TrustCurve trustCurve(const std::vector<Json>& results);

std::string trustPlot(const TrustCurve& curve);

}  // namespace posture::app
