// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/refine/sample_maps.h>

#include "functional_map.h"
#include "nearest_rows.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace posture {
namespace {

using Block = Eigen::MatrixXf;

double oneWayDistortion(const Matrix& distances_a,
                        const Matrix& confidence_a,
                        const Matrix& distances_b,
                        const Matrix& confidence_b,
                        const std::vector<int>& map) {
  double change = 0, length = 0;
  const int s = static_cast<int>(map.size());
  for (int j = 0; j < s; ++j)
    for (int i = 0; i < j; ++i) {
      const double w = confidence_a(i, j) * confidence_b(map[i], map[j]);
      change += w * std::abs(distances_a(i, j) - distances_b(map[i], map[j]));
      length += w * distances_a(i, j);
    }
  return length > 0 ? change / length : 1;
}

/// How far apart two maps are on the second shape, in the mean.
double meanGap(const SampledShape& b, const SampleMap& x, const SampleMap& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.forward.size(); ++i) sum += b.distances(x.forward[i], y.forward[i]);
  return sum / static_cast<double>(x.forward.size());
}

/// The first `s` samples alone: any prefix is spread evenly too.
SampledShape prefix(const SampledShape& shape, int s) {
  return {shape.functions.topRows(s),
          shape.distances.topLeftCorner(s, s),
          shape.confidence.topLeftCorner(s, s),
          shape.form.topRows(s),
          shape.spacing * std::sqrt(static_cast<double>(shape.form.rows()) / s)};
}

/// A map of a prefix, with every other sample going along with its nearest in the prefix.
SampleMap extend(const SampleMap& map, const SampledShape& a, const SampledShape& b) {
  const auto spread = [](const std::vector<int>& known, const Matrix& distances) {
    const int s = static_cast<int>(known.size());
    std::vector<int> all(distances.rows());
    for (int i = 0; i < distances.rows(); ++i) {
      Eigen::Index nearest = 0;
      distances.col(i).head(s).minCoeff(&nearest);
      all[i] = known[nearest];
    }
    return all;
  };
  return {spread(map.forward, a.distances), spread(map.backward, b.distances), 0};
}

/// Both directions by nearest neighbours between two sets of 3-D points.
SampleMap nearestMap(const Eigen::Ref<const Block>& a, const Eigen::Ref<const Block>& b) {
  SampleMap map;
  nearestBothWays(a, b, map.forward, map.backward);
  return map;
}

constexpr std::array<std::array<int, 3>, 6> AXIS_ORDERS{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// All 48 signed orders of three columns.
std::vector<Block> signedOrders(const Block& three) {
  std::vector<Block> all;
  for (const auto& order : AXIS_ORDERS)
    for (int signs = 0; signs < 8; ++signs) {
      Block turned(three.rows(), 3);
      for (int k = 0; k < 3; ++k)
        turned.col(k) = three.col(order[k]) * ((signs >> k & 1) ? -1.0f : 1.0f);
      all.push_back(turned);
    }
  return all;
}

std::vector<int> range(int first, int last, int step) {
  std::vector<int> sizes;
  for (int k = first; k <= last; k += step) sizes.push_back(k);
  return sizes;
}

/// By increasing distortion, without those close to a better one.
std::vector<SampleMap> distinct(std::vector<SampleMap> maps, const SampledShape& b, int most) {
  std::stable_sort(maps.begin(), maps.end(), [](const SampleMap& x, const SampleMap& y) {
    return x.distortion < y.distortion;
  });
  std::vector<SampleMap> kept;
  for (SampleMap& map : maps) {
    if (static_cast<int>(kept.size()) >= most) break;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const SampleMap& other) {
      return meanGap(b, map, other) < b.spacing;
    });
    if (!known) kept.push_back(std::move(map));
  }
  return kept;
}

/// A start and the sizes of basis it is refined through.
struct Seed {
  SampleMap map;
  std::vector<int> sizes;
};

std::vector<SampleMap> refineAll(const SampledShape& a,
                                 const SampledShape& b,
                                 std::vector<Seed>& seeds) {
  std::vector<SampleMap> maps(seeds.size());
  parallelFor(static_cast<int>(seeds.size()), [&](int i) {
    maps[i] = std::move(seeds[i].map);
    zoomOut(a, b, seeds[i].sizes, maps[i]);
    maps[i].distortion = distortion(a, b, maps[i]);
  });
  return maps;
}

/// Fewer samples do while the basis is small.
constexpr int COARSE_SAMPLES = 200;

std::vector<SampleMap> seededMaps(const SampledShape& a, const SampledShape& b, int most) {
  const int s =
      std::min({COARSE_SAMPLES, static_cast<int>(a.form.rows()), static_cast<int>(b.form.rows())});
  const SampledShape coarse_a = prefix(a, s), coarse_b = prefix(b, s);
  std::vector<Seed> low, high;
  for (const Block& turned : signedOrders(coarse_a.form.cast<float>())) {
    const SampleMap map = nearestMap(turned, coarse_b.form.cast<float>());
    low.push_back({map, range(4, 16, 2)});
    low.push_back({map, range(8, 16, 2)});
  }
  for (const Block& turned : signedOrders(coarse_a.functions.middleCols(1, 3)))
    low.push_back({nearestMap(turned, coarse_b.functions.middleCols(1, 3)), range(4, 16, 2)});
  std::vector<SampleMap> starts = distinct(refineAll(coarse_a, coarse_b, low), coarse_b, most);
  for (const SampleMap& map : starts)
    high.push_back({extend(map, a, b), range(20, SAMPLE_BASIS, 4)});
  for (const Block& turned : signedOrders(a.form.cast<float>()))
    high.push_back({nearestMap(turned, b.form.cast<float>()), range(28, SAMPLE_BASIS, 4)});
  return distinct(refineAll(a, b, high), b, most);
}

}  // namespace

double distortion(const SampledShape& a, const SampledShape& b, const SampleMap& map) {
  return 0.5 *
         (oneWayDistortion(a.distances, a.confidence, b.distances, b.confidence, map.forward) +
          oneWayDistortion(b.distances, b.confidence, a.distances, a.confidence, map.backward));
}

void zoomOut(const SampledShape& a,
             const SampledShape& b,
             const std::vector<int>& sizes,
             SampleMap& map) {
  const int available = static_cast<int>(std::min(a.functions.cols(), b.functions.cols()));
  for (const int size : sizes) {
    const int k = std::min(size, available);
    const Block fa = a.functions.leftCols(k), fb = b.functions.leftCols(k);
    const auto [joint_a, joint_b] =
        jointEmbedding(fa, fb, fitSampledMaps(fa, fb, map.forward, map.backward));
    nearestBothWays(joint_a, joint_b, map.forward, map.backward);
  }
}

std::vector<SampleMap> symmetries(const SampledShape& shape, int most) {
  SampleMap identity;
  identity.forward.resize(shape.form.rows());
  std::iota(identity.forward.begin(), identity.forward.end(), 0);
  std::vector<SampleMap> maps = seededMaps(shape, shape, most + 1);
  maps.erase(std::remove_if(maps.begin(),
                            maps.end(),
                            [&](const SampleMap& map) {
                              return meanGap(shape, map, identity) < shape.spacing;
                            }),
             maps.end());
  if (static_cast<int>(maps.size()) > most) maps.resize(most);
  return maps;
}

std::vector<SampleMap> poolOfMaps(const SampledShape& a, const SampledShape& b, int most) {
  constexpr int SYMMETRIES = 4, BEST = 5;
  std::vector<SampleMap> pool = seededMaps(a, b, most);
  const std::vector<SampleMap> of_a = symmetries(a, SYMMETRIES), of_b = symmetries(b, SYMMETRIES);
  std::vector<Seed> seeds;
  const std::vector<int> sizes = range(28, SAMPLE_BASIS, 4);
  for (int i = 0; i < std::min<int>(BEST, static_cast<int>(pool.size())); ++i) {
    for (const SampleMap& own : of_a) seeds.push_back({composed(own, pool[i]), sizes});
    for (const SampleMap& own : of_b) seeds.push_back({composed(pool[i], own), sizes});
  }
  for (SampleMap& map : refineAll(a, b, seeds)) pool.push_back(std::move(map));
  return distinct(std::move(pool), b, most);
}

}  // namespace posture
