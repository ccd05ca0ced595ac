// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/matching/assignment.h>
#include <posture/matching/candidates.h>
#include <posture/mesh/nearest_rotation.h>

#include <algorithm>

namespace posture {
namespace {

CostMatrix distances(const Points& source, const Points& target) {
  CostMatrix cost(source.rows(), target.rows());
  for (int i = 0; i < source.rows(); ++i)
    cost.row(i) = (target.rowwise() - source.row(i)).rowwise().norm().transpose();
  return cost;
}

/// `source` moved by the rigid motion that lowers the sum of distances to its counterparts: weights
/// 1 / distance make the sum of squares one of distances (Weiszfeld 1937).
Points moveOnto(const Points& source, const Points& target, const Assignment& assignment) {
  if (!(assignment.cost > 0)) return source;
  const int s = static_cast<int>(source.rows());
  Points to = source;
  Vector weight = Vector::Zero(s);
  const double floor = 1e-3 * assignment.cost / s;  // an exact match pulls finitely
  for (int i = 0; i < s; ++i) {
    if (assignment.column_of_row[i] < 0) continue;
    to.row(i) = target.row(assignment.column_of_row[i]);
    weight[i] = 1 / std::max((to.row(i) - source.row(i)).norm(), floor);
  }
  weight /= weight.sum();
  const Eigen::RowVector3d from_mean = weight.transpose() * source,
                           to_mean = weight.transpose() * to;
  const Eigen::Matrix3d covariance =
      (source.rowwise() - from_mean).transpose() * weight.asDiagonal() * (to.rowwise() - to_mean);
  return ((source.rowwise() - from_mean) * nearestRotation(covariance)).rowwise() + to_mean;
}

/// From one choice of signs to the nearest optimum of assignment and rigid motion together: each is
/// the best for the other in turn, until E_H falls by less than a hundredth.
Candidate align(const Points& source, const Points& target, const std::array<int, 3>& signs) {
  const Eigen::RowVector3d flip(signs[0], signs[1], signs[2]);
  Points moved = source.array().rowwise() * flip.array();
  Assignment assignment = minimumCostAssignment(distances(moved, target));
  while (true) {
    const Points closer = moveOnto(moved, target, assignment);
    Assignment better = minimumCostAssignment(distances(closer, target));
    const bool settled = !(better.cost < 0.99 * assignment.cost);
    if (better.cost < assignment.cost) {
      moved = closer;
      assignment = std::move(better);
    }
    if (settled) break;
  }
  Candidate candidate;
  candidate.axis_signs = signs;
  candidate.cost = assignment.cost;
  for (int i = 0; i < source.rows(); ++i)
    if (assignment.column_of_row[i] >= 0)
      candidate.matches.push_back({i, assignment.column_of_row[i]});
  return candidate;
}

}  // namespace

std::vector<Candidate> alignmentCandidates(const CanonicalForm& source,
                                           const CanonicalForm& target) {
  std::vector<Candidate> candidates(8);
  parallelFor(8, [&](int k) {
    const std::array<int, 3> signs{
        (k & 1) != 0 ? -1 : 1, (k & 2) != 0 ? -1 : 1, (k & 4) != 0 ? -1 : 1};
    candidates[k] = align(source.landmarks, target.landmarks, signs);
  });
  return candidates;
}

}  // namespace posture
