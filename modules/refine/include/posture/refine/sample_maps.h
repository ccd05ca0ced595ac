// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// What maps between the samples of two shapes are found from. Both shapes in one unit of length.
struct SampledShape {
  Eigen::MatrixXf functions;  ///< s x k, eigenfunctions at the samples, the constant one first
  Matrix distances;           ///< s x s, geodesic
  Matrix confidence;          ///< s x s, in [0, 1]: of each distance
  Points form;                ///< s x 3, canonical form in its principal frame
  double spacing = 0;         ///< covering radius of the samples
};

/// A map between the samples of two shapes, both ways.
struct SampleMap {
  std::vector<int> forward;   ///< sample of the first shape -> sample of the second
  std::vector<int> backward;  ///< and back
  double distortion = 0;      ///< mean |difference of distances|, both ways, over the mean distance
};

/// The second map after the first. \tparam Map  with `forward` and `backward`.
template <class Map>
Map composed(const Map& first, const Map& second) {
  Map map;
  for (int v : first.forward) map.forward.push_back(second.forward[v]);
  for (int v : second.backward) map.backward.push_back(first.backward[v]);
  return map;
}

/// Mean change of the distances between samples under a map, both ways, each pair weighted by the
/// confidence of both its distances; relative to the mean distance.
double distortion(const SampledShape& a, const SampledShape& b, const SampleMap& map);

/// Functions by which candidates are matched in the end; maps of vertices go on from there.
constexpr int SAMPLE_BASIS = 36;

/// Bijective ZoomOut (Melzi et al. 2019; Ren et al. 2021) on the samples: for each size of basis in
/// turn, the functional maps of both directions, then nearest neighbours in their joint embedding.
void zoomOut(const SampledShape& a,
             const SampledShape& b,
             const std::vector<int>& sizes,
             SampleMap& map);

/// Maps of a shape onto itself that move it, mirrored ones among them; by increasing distortion.
std::vector<SampleMap> symmetries(const SampledShape& shape, int most);

/// Different maps between two shapes, by increasing distortion: from all orders and signs of the
/// canonical forms' axes and of the first three eigenfunctions, each refined; then, as symmetric
/// bodies have several good answers, the best of them combined with what each shape's own
/// symmetries are.
std::vector<SampleMap> poolOfMaps(const SampledShape& a, const SampledShape& b, int most);

}  // namespace posture
