// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "result.h"

#include <posture/deformation/follow_matches.h>
#include <posture/mesh/edges.h>

#include "verdict.h"

namespace posture {
namespace {

ShapeSummary summarize(const Side& side) {
  ShapeSummary summary;
  summary.vertices = static_cast<int>(side.input.vertices.rows());
  summary.faces = static_cast<int>(side.input.faces.rows());
  summary.cleaning = side.clean.summary;
  summary.clean_vertices = static_cast<int>(side.clean.mesh.vertices.rows());
  for (const Edge& e : meshEdges(side.clean.mesh.faces)) summary.boundary_edges += e.faces == 1;
  summary.area = faceAreas(side.clean.mesh).sum();
  summary.mean_edge_length = meanEdgeLength(side.clean.mesh);
  summary.samples = static_cast<int>(side.shape.landmarks.vertices.size());
  summary.stress = side.shape.form.stress;
  return summary;
}

/// A map between clean vertices in the numbering of the input; loose vertices go where the vertex
/// they follow goes.
std::vector<int> toInput(const std::vector<int>& map,
                         const CleanMesh& source,
                         const CleanMesh& target) {
  std::vector<int> target_vertex(source.clean_vertex.size(), -1);
  for (std::size_t v = 0; v < target_vertex.size(); ++v) {
    const int t = map[source.clean_vertex[v]];
    if (t >= 0) target_vertex[v] = target.input_vertex[t];
  }
  return target_vertex;
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
  summary.orientation = h.orientation;
  summary.target_vertex = toInput(h.map.target_vertex, source.clean, target.clean);
  return summary;
}

Correspondence correspondence(const Hypothesis& h,
                              const std::vector<int>& target_vertex,
                              const Side& source,
                              const Side& target) {
  const std::vector<int> face_of =
      vertexFaces(target.input.faces, static_cast<int>(target.input.vertices.rows()));
  Correspondence result;
  result.on_target.resize(target_vertex.size());
  result.confidence = Vector::Zero(target_vertex.size());
  for (std::size_t v = 0; v < target_vertex.size(); ++v) {
    const int t = target_vertex[v];
    if (t < 0) continue;
    SurfacePoint& point = result.on_target[v];
    point.vertex = t;
    point.face = face_of[t];
    for (int k = 0; k < 3; ++k)
      if (point.face >= 0 && target.input.faces(point.face, k) == t) point.barycentric[k] = 1;
    result.confidence[v] = h.map.confidence[source.clean.clean_vertex[v]];
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
  std::vector<int> loose, anchor;
  for (int v = 0; v < source.input.vertices.rows(); ++v)
    if (source.clean.offset[v] > 0) {
      loose.push_back(v);
      anchor.push_back(source.clean.clean_vertex[v]);
    }
  Points extra(loose.size(), 3);
  for (std::size_t i = 0; i < loose.size(); ++i)
    extra.row(i) = scale * source.input.vertices.row(loose[i]);
  const Points moved = followMatches(mesh, known, places, extra, anchor);

  Points deformed(source.input.vertices.rows(), 3);
  for (int v = 0; v < deformed.rows(); ++v)
    deformed.row(v) = moved.row(source.clean.clean_vertex[v]);
  for (std::size_t i = 0; i < loose.size(); ++i)
    deformed.row(loose[i]) = moved.row(mesh.vertices.rows() + i);
  return deformed;
}

}  // namespace

RegistrationResult assembleResult(const Side& source,
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
  giveVerdict(result);
  return result;
}

}  // namespace posture
