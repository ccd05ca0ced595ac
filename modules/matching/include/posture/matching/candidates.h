// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/embedding/canonical_form.h>

#include <array>
#include <vector>

namespace posture {

/// A source sample and the target sample it is assigned to: indices into the shapes' landmarks.
struct Match {
  int source;
  int target;
};

/// One way of laying the canonical forms over each other.
struct Candidate {
  std::array<int, 3> axis_signs{};  ///< by which the source's axes were multiplied at the start
  std::vector<Match> matches;       ///< one-to-one, by source sample
  double cost = 0;                  ///< E_H, the sum of the matches' distances in the embedding
};

/// The 2^3 candidates of section 4.1: both forms lie in the frames of their covariances, whose
/// signs are open; for each choice of signs the assignment of least total distance, E_H. The frames
/// of two poses differ by a few degrees more than their signs, so each candidate is then turned
/// onto its matches and assigned anew until E_H settles.
std::vector<Candidate> alignmentCandidates(const CanonicalForm& source,
                                           const CanonicalForm& target);

}  // namespace posture
