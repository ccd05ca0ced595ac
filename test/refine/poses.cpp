// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refine/poses.h"

#include <posture/core/rng.h>
#include <posture/embedding/canonical_form.h>
#include <posture/geodesic/fast_marching.h>
#include <posture/mesh/edges.h>
#include <posture/spectral/spectral_basis.h>

#include <Eigen/QR>

#include "support/bodies.h"
#include "support/unit_area.h"
#include <numeric>
#include <utility>

namespace posture::test {
namespace {

constexpr int FUNCTIONS = 150;

Poses make(BodyKind kind) {
  const ArticulatedBody a = body(0, 1000, 0, kind), b = body(3, 1000, 0, kind);
  return {a, b, spectralSurface(a.mesh, FUNCTIONS), spectralSurface(b.mesh, FUNCTIONS)};
}

}  // namespace

SpectralSurface spectralSurface(TriangleMesh mesh, int functions) {
  mesh = unitArea(std::move(mesh));
  SpectralBasis basis = spectralBasis(cotangentLaplacian(mesh), functions);
  return {std::move(mesh), basis.functions, std::move(basis.eigenvalues)};
}

const Poses& poses(BodyKind kind) {
  if (kind == BodyKind::HUMAN) {
    static const Poses human = make(kind);
    return human;
  }
  static const Poses quadruped = make(kind);
  return quadruped;
}

VertexMaps identity(const SpectralSurface& surface) {
  std::vector<int> map(surface.mesh.vertices.rows());
  std::iota(map.begin(), map.end(), 0);
  return {map, map};
}

VertexMaps mirrored(const Poses& of) {
  VertexMaps maps = identity(of.a);
  for (const VertexPair& pair : mirrorTruth(of.body_a, of.body_b))
    maps.forward[pair.source] = pair.target;
  for (const VertexPair& pair : mirrorTruth(of.body_b, of.body_a))
    maps.backward[pair.source] = pair.target;
  return maps;
}

VertexMaps perturbed(const Poses& of, int steps, std::uint64_t seed) {
  Rng rng(seed);
  VertexMaps maps = identity(of.a);
  const VertexNeighbors& neighbors = of.a.neighbors;
  for (std::vector<int>* map : {&maps.forward, &maps.backward})
    for (int& v : *map)
      for (int step = 0; step < steps; ++step)
        v = neighbors.begin(v)[rng.below(static_cast<int>(neighbors.end(v) - neighbors.begin(v)))];
  return maps;
}

double meanError(const SpectralSurface& target, const std::vector<int>& map) {
  double sum = 0;
  for (std::size_t v = 0; v < map.size(); ++v)
    sum +=
        (target.mesh.vertices.row(map[v]) - target.mesh.vertices.row(static_cast<Eigen::Index>(v)))
            .norm();
  return sum / static_cast<double>(map.size()) / meanEdgeLength(target.mesh);
}

Matrix randomRotation(int size, std::uint64_t seed) {
  Rng rng(seed);
  Matrix m(size, size);
  for (int i = 0; i < m.size(); ++i) m.data()[i] = rng.normal();
  return Eigen::HouseholderQR<Matrix>(m).householderQ();
}

Samples::Samples(const SpectralSurface& surface, int count)
    : landmarks(computeLandmarks(surface.mesh, FastMarching(surface.mesh), count)) {
  shape.functions.resize(landmarks.vertices.size(), surface.functions.cols());
  for (std::size_t i = 0; i < landmarks.vertices.size(); ++i)
    shape.functions.row(i) = surface.functions.row(landmarks.vertices[i]);
  shape.distances = sampleDistances(landmarks);
  shape.confidence = landmarks.confidence.cast<double>();
  shape.form = embedSamples(landmarks).landmarks;
  shape.spacing = landmarks.covering_radius;
}

}  // namespace posture::test
