// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/matching/assignment.h>
#include <posture/matching/candidates.h>

namespace posture {
namespace {

Candidate align(const Points& source, const Points& target, const std::array<int, 3>& signs) {
  const Eigen::RowVector3d flip(signs[0], signs[1], signs[2]);
  CostMatrix cost(source.rows(), target.rows());
  for (int i = 0; i < source.rows(); ++i) {
    const Eigen::RowVector3d flipped = source.row(i).cwiseProduct(flip);
    cost.row(i) = (target.rowwise() - flipped).rowwise().norm().transpose();
  }
  const Assignment assignment = minimumCostAssignment(cost);
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
#pragma omp parallel for schedule(dynamic, 1)
  for (int k = 0; k < 8; ++k)
    candidates[k] = align(source.landmarks,
                          target.landmarks,
                          {(k & 1) != 0 ? -1 : 1, (k & 2) != 0 ? -1 : 1, (k & 4) != 0 ? -1 : 1});
  return candidates;
}

}  // namespace posture
