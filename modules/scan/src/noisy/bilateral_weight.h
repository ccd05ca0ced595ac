// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace posture {

/// Neighbours farther than 2.5 sigma do not count; squared.
constexpr double FARTHEST_SQ = 6.25;

/// What a neighbour counts by its distance and by its height above the plane of a point (Fleishman,
/// Drori and Cohen-Or 2003), Gaussians of both: on another sheet little.
/// \param sigma   reach() of distances
/// \param rho     noiseReach() of heights
/// \param sigmas  times rho: the width of the Gaussian of heights
inline double bilateralWeight(
    double distance_sq, double sigma, double height, double rho, double sigmas) {
  return std::exp(-distance_sq / (2 * sigma * sigma) -
                  height * height / (2 * sigmas * sigmas * rho * rho));
}

}  // namespace posture
