// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/mean_value_encoding.h>

#include <Eigen/Dense>
#include <ceres/ceres.h>

#include "mean_value_term.h"
#include <cmath>

namespace posture {
namespace {

using Eigen::Vector3d;

/// Rotation, translation and scale that take `from` to `to` (Umeyama 1991).
Eigen::Affine3d similarity(const Points& from, const Points& to) {
  constexpr double IN_LINE = 1e-9;
  require(from.rows() >= 3, "decodeMeanValues: a part with fewer than three fixed vertices");
  for (const Points* points : {&from, &to}) {
    const Points centred = points->rowwise() - points->colwise().mean();
    const Vector3d spread = Eigen::JacobiSVD<Matrix>(centred).singularValues();
    require(spread[1] > IN_LINE * spread[0],
            "decodeMeanValues: the fixed vertices of a part lie in one line");
  }
  Eigen::Affine3d motion;
  motion.matrix() = Eigen::umeyama(Matrix(from.transpose()), Matrix(to.transpose()), true);
  return motion;
}

/// Each connected part laid out and put onto its fixed vertices.
Points laidOut(const MeanValueEncoding& encoding,
               const std::vector<int>& fixed_row,
               const Points& fixed_places) {
  Points places(encoding.vertexCount(), 3);
  std::vector<Eigen::Quaterniond> turn(encoding.vertexCount());
  std::vector<double> unit(encoding.vertexCount());
  std::vector<int> part;
  const auto finish = [&] {
    std::vector<int> known;
    for (int v : part)
      if (fixed_row[v] >= 0) known.push_back(v);
    Points from(known.size(), 3), to(known.size(), 3);
    for (std::size_t i = 0; i < known.size(); ++i) {
      from.row(i) = places.row(known[i]);
      to.row(i) = fixed_places.row(fixed_row[known[i]]);
    }
    const Eigen::Affine3d motion = similarity(from, to);
    for (int v : part) places.row(v) = (motion * places.row(v).transpose()).transpose();
    part.clear();
  };
  for (const MeanValueEncoding::Step& step : encoding.layout) {
    if (step.from < 0) {
      if (!part.empty()) finish();
      places.row(step.vertex).setZero();
      turn[step.vertex].setIdentity();
      unit[step.vertex] = 1;
    } else {
      places.row(step.vertex) =
          places.row(step.from) + unit[step.from] * (turn[step.from] * step.place).transpose();
      turn[step.vertex] = (turn[step.from] * step.turn).normalized();
      unit[step.vertex] = unit[step.from] * step.ratio;
    }
    part.push_back(step.vertex);
  }
  finish();
  return places;
}

}  // namespace

Points decodeMeanValues(const MeanValueEncoding& encoding,
                        const std::vector<int>& fixed,
                        const Points& places,
                        const Points& start) {
  const int n = encoding.vertexCount();
  require(places.rows() == static_cast<Eigen::Index>(fixed.size()),
          "decodeMeanValues: one place a fixed vertex");
  require(start.rows() == 0 || start.rows() == n, "decodeMeanValues: one start a vertex");
  require(static_cast<int>(encoding.layout.size()) == n,
          "decodeMeanValues: an encoding without a layout");
  std::vector<int> fixed_row(n, -1);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    require(fixed[i] >= 0 && fixed[i] < n && fixed_row[fixed[i]] < 0,
            "decodeMeanValues: a fixed vertex twice or out of range");
    fixed_row[fixed[i]] = static_cast<int>(i);
  }
  const Points first = laidOut(encoding, fixed_row, places);
  Points decoded = start.rows() > 0 ? start : first;
  for (int v = 0; v < n; ++v)
    if (fixed_row[v] >= 0) decoded.row(v) = places.row(fixed_row[v]);
  // Some of Ceres' tolerances are absolute: in a frame of size about one. A power of two changes no
  // digit.
  const double size = (first.colwise().maxCoeff() - first.colwise().minCoeff()).norm();
  const double unit = std::exp2(std::round(std::log2(size)));
  decoded /= unit;
  ceres::Problem problem;
  for (int v = 0; v < n; ++v) {
    auto* term = new MeanValueTerm(encoding, v, 1);
    problem.AddResidualBlock(term, nullptr, term->parametersIn(decoded));
  }
  for (int v : fixed) problem.SetParameterBlockConstant(decoded.row(v).data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-20;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  decoded *= unit;
  for (int v : fixed) decoded.row(v) = places.row(fixed_row[v]);
  return decoded;
}

}  // namespace posture
