// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "functional_map.h"

#include <posture/core/parallel.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace posture {
namespace {

using Block = Eigen::MatrixXf;

/// More functions than places to know them from leave directions undetermined.
constexpr float RIDGE = 1e-6f;

Block solve(Block normal, const Block& right) {
  normal.diagonal().array() += RIDGE * normal.diagonal().mean();
  return normal.llt().solve(right);
}

}  // namespace

FunctionalMaps fitFunctionalMaps(const FunctionValues& a, const FunctionValues& b) {
  const Block weighted_b = a.weight.asDiagonal() * b.on_other;
  const Block weighted_a = b.weight.asDiagonal() * a.on_other;
  Block normal_a = a.gram, normal_b = b.gram, cross;
  inParallel(
      [&] {
        normal_a.noalias() += a.on_other.transpose() * weighted_a;
        normal_b.noalias() += b.on_other.transpose() * weighted_b;
      },
      [&] {
        cross.noalias() = a.own.transpose() * weighted_b;
        cross.noalias() += weighted_a.transpose() * b.own;
      });
  FunctionalMaps maps;
  inParallel([&] { maps.ab = solve(std::move(normal_a), cross); },
             [&] { maps.ba = solve(std::move(normal_b), cross.transpose()); });
  return maps;
}

FunctionalMaps fitFunctionalMaps(const SpectralSurface& a,
                                 const SpectralSurface& b,
                                 int k,
                                 const VertexMaps& maps) {
  const auto values = [&](const SpectralSurface& s, const std::vector<int>& images) {
    const Block own = s.functions.leftCols(k);
    return FunctionValues{
        own, own(images, Eigen::all), s.gram.topLeftCorner(k, k), s.laplacian.mass.cast<float>()};
  };
  return fitFunctionalMaps(values(a, maps.backward), values(b, maps.forward));
}

FunctionalMaps fitSampledMaps(const Block& a,
                              const Block& b,
                              const std::vector<int>& forward,
                              const std::vector<int>& backward) {
  const auto values = [](const Block& own, const std::vector<int>& images) {
    return FunctionValues{
        own, own(images, Eigen::all), own.transpose() * own, Eigen::VectorXf::Ones(own.rows())};
  };
  return fitFunctionalMaps(values(a, backward), values(b, forward));
}

std::pair<Block, Block> jointEmbedding(const Block& a, const Block& b, const FunctionalMaps& maps) {
  Block joint_a(a.rows(), 2 * a.cols()), joint_b(b.rows(), 2 * b.cols());
  joint_a << a, a * maps.ab;
  joint_b << b * maps.ba, b;
  return {std::move(joint_a), std::move(joint_b)};
}

int basisSize(const SpectralSurface& a, const SpectralSurface& b, int size) {
  return static_cast<int>(std::min({Eigen::Index{size}, a.functions.cols(), b.functions.cols()}));
}

double eigenvalueAt(const SpectralSurface& a, const SpectralSurface& b, int k) {
  return 0.5 * (a.eigenvalues[k - 1] + b.eigenvalues[k - 1]);
}

Matrix lowPass(const SpectralSurface& surface, const Matrix& values, int k) {
  const auto f = surface.functions.leftCols(k);
  const Block weighted = surface.laplacian.mass.cast<float>().asDiagonal() * values.cast<float>();
  const Block coefficients = surface.gram.topLeftCorner(k, k).llt().solve(f.transpose() * weighted);
  return (f * coefficients).cast<double>();
}

}  // namespace posture
