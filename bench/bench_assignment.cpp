// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/matching/assignment.h>

#include <benchmark/benchmark.h>

namespace posture {
namespace {

/// Distances between two clouds of the same distribution, as between canonical forms.
CostMatrix cloudDistances(int size) {
  Rng rng(1);
  Points a(size, 3), b(size, 3);
  for (int i = 0; i < a.size(); ++i) {
    a.data()[i] = rng.normal();
    b.data()[i] = a.data()[i] + 0.05 * rng.normal();
  }
  CostMatrix cost(size, size);
  for (int i = 0; i < size; ++i) cost.row(i) = (b.rowwise() - a.row(i)).rowwise().norm();
  return cost;
}

void assign(benchmark::State& state) {
  const CostMatrix cost = cloudDistances(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(minimumCostAssignment(cost));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(assign)
    ->RangeMultiplier(2)
    ->Range(125, 1000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace posture
