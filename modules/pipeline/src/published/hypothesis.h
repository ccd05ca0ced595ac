// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/deformation/common_mesh.h>
#include <posture/dense/dense_map.h>
#include <posture/matching/candidates.h>
#include <posture/pipeline/observer.h>
#include <posture/pipeline/register_shapes.h>

#include <vector>

namespace posture {

/// A candidate with all that speaks for and against it.
struct Hypothesis {
  Candidate candidate;
  double consistency = 0;   ///< mean of C off the diagonal
  std::vector<int> kernel;  ///< indices into candidate.matches
  DenseMap map;
  CommonMeshes common;
  double source_energy = 0;  ///< E(M0)
  double target_energy = 0;  ///< E(M1)

  double energy() const { return source_energy > target_energy ? source_energy : target_energy; }
};

/// One matrix C a candidate.
std::vector<Matrix> consistencyMatrices(const std::vector<Candidate>& candidates,
                                        const Landmarks& source,
                                        const Landmarks& target);

/// Sections 4.2, 5.1 and 5.2 for one candidate.
Hypothesis evaluateCandidate(const EmbeddedShape& source,
                             const EmbeddedShape& target,
                             const Candidate& candidate,
                             const Matrix& consistency,
                             double threshold);

/// The hypothesis of least E_D.
int leastDeformed(const std::vector<Hypothesis>& hypotheses);

std::vector<StagePicture> hypothesisPictures(const EmbeddedShape& source,
                                             const EmbeddedShape& target,
                                             const std::vector<Hypothesis>& hypotheses);

}  // namespace posture
