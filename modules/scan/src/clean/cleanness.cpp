// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/cleanness.h"

#include <posture/core/parallel.h>

#include "points/local_quadric.h"
#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace posture {
namespace {

constexpr int NEAR = 12, AROUND = 24;

}  // namespace

Cleanness cleanness(const Points& points, const NeighborTable& neighbors, const Spacing& spacing) {
  // Of noise alone the second percentile of such residuals, of seven degrees of freedom, is 0.47
  // of the noise.
  constexpr double LOW = 0.02, LOW_OF_NOISE = 0.47;
  // Vertices of meshes have up to 0.06, scans with a noise of a fifth of a pixel 0.1 and more.
  constexpr double LITTLE = 0.08;
  // Turns no face by more than a degree or so.
  constexpr double NEGLIGIBLE = 0.01;
  // Of noise the residuals of twice as many neighbours are as large. Of what quadrics do not fit
  // they are larger: 1.4 to 2.3 times for vertices of meshes, up to 1.2 times for scans, 1.3 times
  // for the vertices of captures.
  constexpr double GROWTH = 1.25;
  const int n = static_cast<int>(points.rows()), looked_at = std::min(n, 5000);
  if (neighbors.cols() < AROUND) return {};
  struct Fit {
    double near, around;
  };
  std::vector<Fit> fits(looked_at);
  parallelFor(looked_at, [&](int s) {
    constexpr double NONE = std::numeric_limits<double>::infinity();
    const int i = static_cast<int>(static_cast<std::int64_t>(s) * n / looked_at);
    if (neighborCount(neighbors, i) < AROUND)
      fits[s] = {NONE, NONE};
    else
      fits[s] = {quadricResidual<NEAR>(points, neighbors, i) / spacing.at[i],
                 quadricResidual<AROUND>(points, neighbors, i) / spacing.at[i]};
  });
  std::vector<double> residuals(looked_at);
  std::transform(fits.begin(), fits.end(), residuals.begin(), [](const Fit& f) { return f.near; });
  std::sort(residuals.begin(), residuals.end());
  const double noise = residuals[static_cast<std::size_t>(LOW * looked_at)] / LOW_OF_NOISE;
  // Where the surface bends least, noise shows most.
  std::sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) {
    return std::pair(a.around, a.near) < std::pair(b.around, b.near);
  });
  const auto half = fits.begin() + looked_at / 2;
  const bool grows =
      2 * std::count_if(
              fits.begin(), half, [](const Fit& f) { return f.around > GROWTH * f.near; }) >
      half - fits.begin();
  return {noise < NEGLIGIBLE || (noise < LITTLE && grows), noise};
}

}  // namespace posture
