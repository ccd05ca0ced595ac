// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/embedding/canonical_form.h>
#include <posture/embedding/scaling.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace posture {
namespace {

/// Turns the points into the frame of their covariance's eigenvectors; returns the eigenvalues.
Eigen::Vector3d toPrincipalFrame(Points& points) {
  points.rowwise() -= points.colwise().mean().eval();
  const Eigen::Matrix3d covariance =
      points.transpose() * points / static_cast<double>(points.rows());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  points = (points * solver.eigenvectors().rowwise().reverse()).eval();
  return solver.eigenvalues().reverse();
}

/// The place x with the least sum_i w_i (|x - X_i| - delta_i)^2, from the embedding of a sample
/// nearby. Each step moves to the mean of where the samples want the point (the majorisation of
/// the stress in one point, Borg and Groenen 1997), which never raises the sum.
Eigen::RowVector3d project(const Points& landmarks,
                           const Eigen::Ref<const Eigen::VectorXf>& distances,
                           const Eigen::Ref<const Eigen::RowVectorXf>& weights,
                           const Eigen::RowVector3d& start,
                           double tolerance) {
  constexpr int MAX_STEPS = 100;
  Eigen::RowVector3d x = start;
  for (int step = 0; step < MAX_STEPS; ++step) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double weight = 0;
    for (int i = 0; i < landmarks.rows(); ++i) {
      const Eigen::RowVector3d from = x - landmarks.row(i);
      const double d = from.norm(), w = weights[i];
      sum += w * landmarks.row(i);
      if (d > 0) sum += (w * distances[i] / d) * from;
      weight += w;
    }
    if (!(weight > 0)) return start;
    const Eigen::RowVector3d better = sum / weight;
    const double moved = (better - x).norm();
    x = better;
    if (moved < tolerance) break;
  }
  return x;
}

}  // namespace

CanonicalForm embedSamples(const Landmarks& samples) {
  require(samples.vertices.size() > 3, "embedSamples: needs more than three samples");
  CanonicalForm form;
  const Matrix distances = sampleDistances(samples);
  form.landmarks = leastSquaresScaling(distances, samples.confidence, classicalScaling(distances));
  form.stress = normalizedStress(distances, samples.confidence, form.landmarks);
  form.eigenvalues = toPrincipalFrame(form.landmarks);
  return form;
}

CanonicalForm computeCanonicalForm(const Landmarks& samples) {
  const int s = static_cast<int>(samples.vertices.size());
  const int n = static_cast<int>(samples.distances.cols());
  CanonicalForm form = embedSamples(samples);
  form.vertices.resize(n, 3);
  std::vector<int> sample_of(n, -1);
  for (int i = 0; i < s; ++i) sample_of[samples.vertices[i]] = i;
  // A hundredth of the spacing of the samples is far below what the embedding can tell.
  const double tolerance = 0.01 * samples.covering_radius;
  constexpr int BLOCK = 64;
  forEach(n, BLOCK, [&](int v) {
    if (sample_of[v] >= 0) {
      form.vertices.row(v) = form.landmarks.row(sample_of[v]);
      return;
    }
    // Paths from v meet the holes that those of its nearest sample meet.
    const int nearest = samples.nearest[v];
    require(nearest >= 0, "canonical form: a vertex that no sample reaches");
    form.vertices.row(v) = project(form.landmarks,
                                   samples.distances.col(v),
                                   samples.confidence.row(nearest),
                                   form.landmarks.row(nearest),
                                   tolerance);
  });
  return form;
}

}  // namespace posture
