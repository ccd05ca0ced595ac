// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include <vector>

namespace posture::test {

/// All of three vertices taken to one place.
inline RegistrationResult resultWith(double score, double trust, int place) {
  RegistrationResult result;
  result.chosen = 0;
  result.score = score;
  result.trust = trust;
  result.correspondence.on_target.assign(3, SurfacePoint{place, -1, Eigen::Vector3d::Zero()});
  result.correspondence.confidence = Vector::Constant(3, trust);
  result.deformed = Points::Constant(3, 3, place);
  return result;
}

/// One with a single answer.
inline RegistrationResult answerWith(double score, int place) {
  RegistrationResult result = resultWith(score, 0.9, place);
  result.alternatives.resize(1);
  result.alternatives[0].score = score;
  result.alternatives[0].refined_score = score;
  result.alternatives[0].correspondence = result.correspondence;
  result.target.area = 1;
  return result;
}

/// A triangle's corners taken to corners, -1: none.
inline RegistrationResult mapOf(double score, std::vector<int> corners) {
  RegistrationResult result = answerWith(score, 0);
  for (std::size_t v = 0; v < corners.size(); ++v)
    result.correspondence.on_target[v].vertex = corners[v];
  return result;
}

}  // namespace posture::test
