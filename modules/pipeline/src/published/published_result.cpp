// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "published/published_result.h"

#include <posture/mesh/corners.h>
#include <posture/mesh/position_of.h>

#include "answer/verdict.h"

namespace posture {
namespace {

ShapeSummary summarize(const Side& side) {
  ShapeSummary summary = summarize(side.given);
  summary.samples = static_cast<int>(side.shape.landmarks.vertices.size());
  summary.stress = side.shape.form.stress;
  return summary;
}

HypothesisSummary summarize(const Hypothesis& h, const Side& source, const Side& target) {
  HypothesisSummary summary;
  summary.axis_signs = h.candidate.axis_signs;
  summary.assignment_cost = h.candidate.cost;
  summary.matched_samples = static_cast<int>(h.candidate.matches.size());
  summary.consistency = h.consistency;
  summary.kernel_samples = static_cast<int>(h.kernel.size());
  for (int t : h.map.target_vertex) summary.accepted_vertices += t >= 0;
  summary.common_vertices = static_cast<int>(h.common.from_source.source.rows());
  summary.source_energy = h.source_energy;
  summary.target_energy = h.target_energy;
  summary.energy = h.energy();
  summary.target_vertex = toInput(h.map.target_vertex, source.given.clean, target.given.clean);
  return summary;
}

Correspondence correspondence(const Hypothesis& h,
                              const std::vector<int>& target_vertex,
                              const Side& source,
                              const Side& target) {
  const std::vector<int> face_of = faceOfEachVertex(
      target.given.input.faces, static_cast<int>(target.given.input.vertices.rows()));
  Correspondence result;
  result.on_target.resize(target_vertex.size());
  result.confidence = Vector::Zero(target_vertex.size());
  for (std::size_t v = 0; v < target_vertex.size(); ++v) {
    const int t = target_vertex[v];
    if (t < 0) continue;
    result.on_target[v] = placeOfVertex(target.given.input.faces, face_of, t);
    result.confidence[v] = h.map.confidence[source.given.clean.clean_vertex[v]];
  }
  return result;
}

/// The source as given, moved onto the target.
Points deform(const Hypothesis& h, const Side& source, const Side& target, double scale) {
  const TriangleMesh& mesh = source.shape.mesh;
  std::vector<char> known(mesh.vertices.rows(), 0);
  Points places = Points::Zero(mesh.vertices.rows(), 3);
  for (std::size_t v = 0; v < known.size(); ++v) {
    const int t = h.map.target_vertex[v];
    if (t < 0) continue;
    known[v] = 1;
    places.row(v) = target.shape.mesh.vertices.row(t);
  }
  return placesOfInput(source.given, mesh, known, places, scale * source.given.input.vertices);
}

}  // namespace

RegistrationResult publishedResult(const Side& source,
                                   const Side& target,
                                   const std::vector<Hypothesis>& hypotheses,
                                   int chosen,
                                   double scale) {
  RegistrationResult result;
  result.source = summarize(source);
  result.target = summarize(target);
  result.chosen = chosen;
  result.scale = scale;
  for (const Hypothesis& h : hypotheses) result.hypotheses.push_back(summarize(h, source, target));
  const Hypothesis& best = hypotheses[chosen];
  result.correspondence =
      correspondence(best, result.hypotheses[chosen].target_vertex, source, target);
  result.deformed = deform(best, source, target, scale);
  givePublishedVerdict(result);
  return result;
}

}  // namespace posture
