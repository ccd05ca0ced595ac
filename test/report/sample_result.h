// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/report/report_json.h>

#include <cmath>
#include <limits>

namespace posture::test {

/// A result of the published method, infinity and NaN among its figures.
inline RegistrationResult sampleResult() {
  RegistrationResult result;
  result.status = Status::REGISTERED;
  result.message = "3 of 4 vertices <found> & \"kept\"";
  result.correspondence.on_target.resize(4);
  for (int i = 0; i < 3; ++i) result.correspondence.on_target[i].vertex = i;
  result.correspondence.confidence = Vector::Constant(4, 0.5);
  result.correspondence.confidence(3) = 0;
  result.hypotheses.resize(3);
  result.hypotheses[0].axis_signs = {1, 1, 1};
  result.hypotheses[0].energy = 2;
  result.hypotheses[1].axis_signs = {1, -1, 1};
  result.hypotheses[1].energy = 5;
  result.hypotheses[1].assignment_cost = std::nan("");
  result.hypotheses[2].axis_signs = {-1, -1, 1};
  result.hypotheses[2].energy = std::numeric_limits<double>::infinity();
  result.chosen = 0;
  result.consistency_threshold = 0.75;
  result.scale = 1.5;
  result.source.vertices = 4;
  result.source.cleaning.welded_vertices = 6;
  result.target.boundary_edges = 12;
  result.timings = {{"", "geodesic", 1.5}, {"", "embedding", 0.5}};
  return result;
}

inline RunDescription sampleRun() {
  RunDescription run;
  run.source = "a<b>.ply";
  run.target = "b.ply";
  run.options = {{"paper", "true"}};
  run.files = {{"correspondence.csv", "where each source vertex is on the target"}};
  run.threads = 2;
  run.seconds = 2.25;
  return run;
}

}  // namespace posture::test
