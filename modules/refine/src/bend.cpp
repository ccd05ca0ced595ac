// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/normals.h>
#include <posture/refine/bend.h>

#include "belief.h"
#include "functional_map.h"
#include "nearest_rows.h"
#include "reduce_dimensions.h"
#include <cmath>
#include <utility>

namespace posture {
namespace {

using Block = Eigen::MatrixXf;

/// The leading principal directions hold what tells neighbours apart.
constexpr int NEAREST_DIMENSIONS = 50;

/// A surface in its own pose and bent onto the other.
struct InBothPoses {
  const SpectralSurface& surface;
  Points own, bent;
};

/// What makes the eigenfunctions as steep as the places are, so that neither outweighs the other:
/// the squared slope of k functions is the sum of their eigenvalues, half of it along each of the
/// two directions of the surface, and they appear twice.
float spectralScale(const SpectralSurface& a, const SpectralSurface& b, int k) {
  const double mean = 0.5 * (a.eigenvalues.head(k).sum() + b.eigenvalues.head(k).sum());
  return static_cast<float>(1 / std::sqrt(2 * 0.5 * mean));
}

Block normalsOf(const SpectralSurface& surface, const Points& places, double weight) {
  return (weight * vertexNormals({places, surface.mesh.faces})).cast<float>();
}

/// Nearest neighbours both ways where everything that is known of two surfaces agrees.
VertexMaps nearestMaps(const InBothPoses& posed_a,
                       const InBothPoses& posed_b,
                       int k,
                       double normal_weight,
                       const VertexMaps& maps) {
  const SpectralSurface &a = posed_a.surface, &b = posed_b.surface;
  const FunctionalMaps c = fitFunctionalMaps(a, b, k, maps);
  const float scale = spectralScale(a, b, k);
  const auto fa = a.functions.leftCols(k), fb = b.functions.leftCols(k);
  Block joint_a(fa.rows(), 2 * k + 12), joint_b(fb.rows(), 2 * k + 12);
  inParallel(
      [&] {
        joint_a << scale * fa, scale * (fa * c.ab), posed_a.own.cast<float>(),
            posed_a.bent.cast<float>(), normalsOf(a, posed_a.own, normal_weight),
            normalsOf(a, posed_a.bent, normal_weight);
      },
      [&] {
        joint_b << scale * (fb * c.ba), scale * fb, posed_b.bent.cast<float>(),
            posed_b.own.cast<float>(), normalsOf(b, posed_b.bent, normal_weight),
            normalsOf(b, posed_b.own, normal_weight);
      });
  reduceDimensions(joint_a, joint_b, NEAREST_DIMENSIONS);
  VertexMaps found;
  nearestAmongGroups(joint_a, joint_b, found.forward, found.backward);
  return found;
}

/// `from` bent towards where its vertices go on `to`.
Points bentOnto(const SpectralSurface& from,
                const SpectralSurface& to,
                const std::vector<int>& matches,
                int k,
                double softness) {
  const Points goals = to.mesh.vertices(matches, Eigen::all);
  const Arap::Attraction attraction = from.arap.attract(softness, belief(from, to, matches));
  return from.arap.pull(lowPass(from, goals, k), goals, attraction, BENDING_STEPS);
}

}  // namespace

VertexMaps spreadToVertices(const SpectralSurface& a,
                            const SpectralSurface& b,
                            const Block& samples_a,
                            const Block& samples_b,
                            const SampleMap& map,
                            int size) {
  const int k = basisSize(a, b, size);
  const FunctionalMaps c =
      fitSampledMaps(samples_a.leftCols(k), samples_b.leftCols(k), map.forward, map.backward);
  auto [joint_a, joint_b] = jointEmbedding(a.functions.leftCols(k), b.functions.leftCols(k), c);
  reduceDimensions(joint_a, joint_b, NEAREST_DIMENSIONS);
  VertexMaps maps;
  nearestAmongGroups(joint_a, joint_b, maps.forward, maps.backward);
  return maps;
}

VertexMaps bend(const SpectralSurface& a,
                const SpectralSurface& b,
                const std::vector<int>& sizes,
                VertexMaps maps) {
  for (const int size : sizes) {
    const int k = basisSize(a, b, size);
    const double softness = eigenvalueAt(a, b, k);
    const InBothPoses posed_a{a, a.mesh.vertices, bentOnto(a, b, maps.forward, k, softness)};
    const InBothPoses posed_b{b, b.mesh.vertices, bentOnto(b, a, maps.backward, k, softness)};
    maps = nearestMaps(posed_a, posed_b, k, 1 / std::sqrt(softness), maps);
  }
  return maps;
}

VertexMaps sharpen(const SpectralSurface& a,
                   const SpectralSurface& b,
                   const std::vector<int>& sizes,
                   VertexMaps maps) {
  // Normals of smoothed surfaces say less than those of bent ones.
  constexpr double NORMAL_SHARE = 0.3;
  for (const int size : sizes) {
    const int k = basisSize(a, b, size);
    const auto smoothed = [k](const SpectralSurface& from,
                              const SpectralSurface& to,
                              const std::vector<int>& matches) {
      return InBothPoses{from,
                         lowPass(from, from.mesh.vertices, k),
                         lowPass(from, to.mesh.vertices(matches, Eigen::all), k)};
    };
    maps = nearestMaps(smoothed(a, b, maps.forward),
                       smoothed(b, a, maps.backward),
                       k,
                       NORMAL_SHARE / std::sqrt(eigenvalueAt(a, b, k)),
                       maps);
  }
  return maps;
}

}  // namespace posture
