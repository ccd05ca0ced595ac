// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/embedding/scaling.h>

#include <ceres/ceres.h>

#include <cmath>

namespace posture {
namespace {

/// sum_{i<j} w (d - delta)^2 and its gradient. Each row is summed by itself, so the result does not
/// depend on how rows are shared among threads.
class Stress : public ceres::FirstOrderFunction {
 public:
  Stress(const Matrix& distances, const Table& weights)
      : distances_(distances), weights_(weights) {}

  int NumParameters() const override { return 3 * static_cast<int>(distances_.rows()); }

  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    const int s = static_cast<int>(distances_.rows());
    const Eigen::Map<const Points> x(parameters, s, 3);
    Vector row_cost(s);
    constexpr int BLOCK = 32;
    forEach(s, BLOCK, [&](int i) {
      const double xi = x(i, 0), yi = x(i, 1), zi = x(i, 2);
      double sum = 0, gx = 0, gy = 0, gz = 0;
      for (int j = 0; j < s; ++j) {
        const double dx = xi - x(j, 0), dy = yi - x(j, 1), dz = zi - x(j, 2);
        const double d = std::sqrt(dx * dx + dy * dy + dz * dz);
        const double w = weights_(i, j), misfit = d - distances_(j, i);
        sum += w * misfit * misfit;
        // At coinciding points any direction descends; none is taken.
        const double pull = d > 0 ? w * misfit / d : 0;
        gx += pull * dx;
        gy += pull * dy;
        gz += pull * dz;
      }
      row_cost[i] = sum;
      if (gradient != nullptr) Eigen::Map<Points>(gradient, s, 3).row(i) << 2 * gx, 2 * gy, 2 * gz;
    });
    *cost = 0.5 * row_cost.sum();
    return true;
  }

 private:
  const Matrix& distances_;
  const Table& weights_;
};

}  // namespace

Points leastSquaresScaling(const Matrix& distances, const Table& weights, const Points& start) {
  const Eigen::Index s = distances.rows();
  require(distances.cols() == s && weights.rows() == s && weights.cols() == s && start.rows() == s,
          "leastSquaresScaling: sizes do not agree");
  // In units of about the mean distance, as some of Ceres' tolerances are absolute. A power of two
  // changes no digit.
  const double mean = distances.mean();
  const double unit = mean > 0 ? std::exp2(std::round(std::log2(mean))) : 1;
  const Matrix relative_distances = distances / unit;
  Points points = start / unit;
  const ceres::GradientProblem problem(new Stress(relative_distances, weights));
  ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = ceres::LBFGS;
  options.max_num_iterations = 3000;
  options.function_tolerance = 1e-9;
  options.logging_type = ceres::SILENT;
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, problem, points.data(), &summary);
  return points * unit;
}

double normalizedStress(const Matrix& distances, const Table& weights, const Points& points) {
  double misfit = 0, total = 0;
  for (int i = 0; i < distances.rows(); ++i)
    for (int j = 0; j < i; ++j) {
      const double d = (points.row(i) - points.row(j)).norm() - distances(i, j);
      misfit += weights(i, j) * d * d;
      total += weights(i, j) * distances(i, j) * distances(i, j);
    }
  return total > 0 ? std::sqrt(misfit / total) : 0;
}

}  // namespace posture
