// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/work/refined_shape.h"

#include <posture/core/error.h>
#include <posture/embedding/canonical_form.h>
#include <posture/geodesic/landmarks.h>
#include <posture/mesh/areas.h>
#include <posture/refine/tip_maps.h>

#include "sides/given_shape.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace posture {
namespace {

/// Maps are exact to a fraction of an edge of these meshes before the last stage takes them to the
/// full ones; comparing all vertices with all, the time goes with the product of both sides'.
constexpr int WORK_VERTICES = 5000, COARSE_VERTICES = 1500, SAMPLES = 500;

/// Where one side has n vertices, fewer than WORK_VERTICES, the work mesh of the other has
/// WORK_VERTICES^2 / n, and the product stays: reduced to n, a fine surface is another shape than a
/// light mesh of the same body. This is the least n that counts.
constexpr int FEWEST_WORK_VERTICES = WORK_VERTICES / 2;

/// A surface this many times as coarse as the other is brought to so many vertices; it bends, and
/// is compared, no finer than it has any. On a third of its vertices a mesh is 1.7 times as coarse
/// or more; half a body is 1.4 times as coarse as the whole.
constexpr double MUCH_COARSER = 1.6;
constexpr int DENSE_VERTICES = 6000;

/// The smallest of their waves is still five edges long on the coarse mesh.
constexpr int FUNCTIONS = 200;

/// What tells a shape at all: each eigenfunction takes a few vertices.
constexpr int LEAST_VERTICES = 20, VERTICES_PER_FUNCTION = 4;

ReducedMesh reduced(const std::string& side, const TriangleMesh& mesh, int count) {
  try {
    ReducedMesh reduced = reduceMesh(mesh, count);
    if (reduced.mesh.vertices.rows() >= LEAST_VERTICES) return reduced;
  } catch (const InputError&) {  // no face is left
  }
  throw InputError(side + " is no surface: hardly any of its faces lie side by side in twos");
}

}  // namespace

FacePoint RefinedShape::onMainSurface(const FacePoint& place) const {
  if (parts.empty()) return place;
  const FacePart& part = parts[place.face];
  return {part.face, part.corners * place.barycentric};
}

std::vector<int> RefinedShape::tips() const {
  std::vector<int> vertices;
  for (int tip : tipsOf(samples)) vertices.push_back(sample_vertex[tip]);
  return vertices;
}

SpectralSurface RefinedShape::workSurface() const {
  return {work.mesh, basis.functions, basis.eigenvalues};
}

SpectralSurface RefinedShape::coarseSurface() const {
  return {coarse.mesh, basis.functions(coarse.vertex, Eigen::all), basis.eigenvalues};
}

Eigen::MatrixXf RefinedShape::coarseFunctions() const {
  return basis.functions(coarse.vertex, Eigen::all).cast<float>();
}

bool isMuchCoarser(const TriangleMesh& surface, const TriangleMesh& other) {
  return surface.vertices.rows() < DENSE_VERTICES &&
         coarseness(surface) > MUCH_COARSER * coarseness(other);
}

RefinedShape fullSide(const std::string& side, const TriangleMesh& surface, bool too_coarse) {
  const auto n = surface.vertices.rows();
  if (n < LEAST_VERTICES)
    throw InputError(side + " has only " + std::to_string(n) +
                     " usable vertices: too few to tell a shape");
  RefinedShape shape;
  if (too_coarse) {
    SplitMesh dense = splitLongEdges(surface, DENSE_VERTICES);
    shape.full = std::move(dense.mesh);
    shape.parts = std::move(dense.parts);
  } else {
    shape.full = surface;
  }
  return shape;
}

void reduceSide(const std::string& side, int others, RefinedShape& shape) {
  const int shared = std::clamp(others, FEWEST_WORK_VERTICES, WORK_VERTICES);
  shape.work = reduced(side, shape.full, WORK_VERTICES * WORK_VERTICES / shared);
  shape.coarse = reduced(side, shape.work.mesh, COARSE_VERTICES);
}

void addSpectrum(const std::string& side, RefinedShape& shape) {
  const int n = static_cast<int>(shape.work.mesh.vertices.rows());
  naming(side, [&] {
    shape.basis = spectralBasis(cotangentLaplacian(shape.work.mesh),
                                std::min(FUNCTIONS, n / VERTICES_PER_FUNCTION));
  });
}

void addSamples(const std::string& side, RefinedShape& shape) {
  const Landmarks landmarks = sampleSide(side, shape.work.mesh, SAMPLES);
  const CanonicalForm form = embedSamples(landmarks);
  shape.stress = form.stress;
  shape.sample_vertex = landmarks.vertices;
  shape.samples = {shape.basis.functions(landmarks.vertices, Eigen::all).cast<float>(),
                   sampleDistances(landmarks),
                   landmarks.confidence.cast<double>(),
                   form.landmarks,
                   landmarks.covering_radius};
}

RefinedShape rescaled(RefinedShape shape, double scale) {
  if (scale == 1) return shape;
  shape.full.vertices *= scale;
  shape.work.mesh.vertices *= scale;
  shape.coarse.mesh.vertices *= scale;
  shape.basis.functions /= scale;
  shape.basis.eigenvalues /= scale * scale;
  shape.samples.functions /= static_cast<float>(scale);
  shape.samples.distances *= scale;
  shape.samples.form *= scale;
  shape.samples.spacing *= scale;
  return shape;
}

double distanceRatio(const SampledShape& a, const SampledShape& b, const SampleMap& map) {
  std::vector<std::pair<double, double>> ratios;  // logarithm, weight
  const auto add = [&](double on_a, double on_b, double weight) {
    if (on_a > 0 && on_b > 0 && weight > 0) ratios.emplace_back(std::log(on_b / on_a), weight);
  };
  const int sa = static_cast<int>(map.forward.size()), sb = static_cast<int>(map.backward.size());
  for (int j = 0; j < sa; ++j)
    for (int i = 0; i < j; ++i) {
      const int x = map.forward[i], y = map.forward[j];
      add(a.distances(i, j), b.distances(x, y), a.confidence(i, j) * b.confidence(x, y));
    }
  for (int j = 0; j < sb; ++j)
    for (int i = 0; i < j; ++i) {
      const int x = map.backward[i], y = map.backward[j];
      add(a.distances(x, y), b.distances(i, j), a.confidence(x, y) * b.confidence(i, j));
    }
  if (ratios.empty()) return 1;
  std::sort(ratios.begin(), ratios.end());
  const double half =
      0.5 * std::accumulate(ratios.begin(), ratios.end(), 0.0, [](double sum, const auto& r) {
        return sum + r.second;
      });
  double below = 0;
  for (const auto& [log_ratio, weight] : ratios)
    if ((below += weight) >= half) return std::exp(log_ratio);
  return 1;
}

}  // namespace posture
