// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/geodesic/fast_marching.h>

#include <benchmark/benchmark.h>

#include "support/shapes.h"

namespace posture {
namespace {

/// One source over the whole sphere. Items are vertices: their rate falls only as the mesh
/// outgrows the caches.
void march(benchmark::State& state) {
  const TriangleMesh sphere = test::sphere(static_cast<int>(state.range(0)));
  const FastMarching marching(sphere);
  GeodesicField field;
  int source = 0;
  for (auto _ : state) {
    marching.march(source, field);
    benchmark::DoNotOptimize(field.distance.data());
    source = (source + 101) % marching.vertexCount();
  }
  state.SetItemsProcessed(state.iterations() * marching.vertexCount());
}
BENCHMARK(march)->DenseRange(4, 8)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace posture
