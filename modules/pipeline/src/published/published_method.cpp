// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "published/published_method.h"

#include <posture/core/parallel.h>
#include <posture/matching/consistency.h>

#include "published/hypothesis.h"
#include "published/published_result.h"
#include "published/published_samples.h"

namespace posture {

// A stage a line; sections and equations are the paper's.
RegistrationResult publishedMethod(const GivenShape& source_given,
                                   const GivenShape& target_given,
                                   StageClock& clock) {
  // 4.1: Voronoi samples, geodesic distances by fast marching, confidence w = 1 - m_h / m.
  EmbeddedShape source{source_given.clean.mesh, {}, {}}, target{target_given.clean.mesh, {}, {}};
  clock.stage("geodesic", 0.36, [&] {
    source.landmarks = sampleSide("source", source.mesh);
    target.landmarks = sampleSide("target", target.mesh);
  });
  const double scale = commonScale(source.landmarks, target.landmarks);
  rescale(source, scale);
  clock.show([&] { return samplePictures(source, target); });

  // 4.1: canonical forms by weighted least-squares scaling, the other vertices projected.
  clock.stage("embedding", 0.2, [&] {
    source.form = computeCanonicalForm(source.landmarks);
    target.form = computeCanonicalForm(target.landmarks);
  });
  clock.show([&] { return formPictures(source, target); });

  // 4.1: the 2^k sign alignments of the principal axes, an optimal assignment each.
  const std::vector<Candidate> candidates =
      clock.stage("assignment", 0.1, [&] { return alignmentCandidates(source.form, target.form); });

  // 4.2: consistency matrices C; c0 = mu - 3 sigma learned over all of them.
  const std::vector<Matrix> consistency = clock.stage("consistency", 0.03, [&] {
    return consistencyMatrices(candidates, source.landmarks, target.landmarks);
  });
  const double threshold = consistencyThreshold(consistency);

  // 4.2 and 5, for each candidate: kernel, thin-plate spline, dense map; common meshes, E_D.
  std::vector<Hypothesis> hypotheses(candidates.size());
  clock.stage("hypotheses", 0.22, [&] {
    parallelFor(static_cast<int>(candidates.size()), [&](int k) {
      hypotheses[k] = evaluateCandidate(source, target, candidates[k], consistency[k], threshold);
    });
  });
  clock.show([&] { return hypothesisPictures(source, target, hypotheses); });

  // 5: the candidate of least deformation wins.
  const int chosen = leastDeformed(hypotheses);
  RegistrationResult result = clock.stage("result", 0.0, [&] {
    return publishedResult(
        {source_given, source}, {target_given, target}, hypotheses, chosen, scale);
  });
  result.consistency_threshold = threshold;
  return result;
}

}  // namespace posture
