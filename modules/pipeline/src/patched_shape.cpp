// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patched_shape.h"

#include <posture/mesh/bridge_pieces.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/hole_patches.h>
#include <posture/mesh/position_of.h>

#include "pose.h"
#include "verdict.h"
#include "way_back.h"
#include <limits>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// How far beyond the rim of a hole, in square roots of the area, a place may lie and still be
/// taken for one on it: maps of surfaces with holes are off by 0.011 to 0.015 in the mean.
constexpr double BEYOND_RIM = 0.015;

/// For the vertices of patches a vertex of the input at the rim beside them: an edge away, or near
/// enough; -1: none.
std::vector<int> rimVertices(const TriangleMesh& input, const PatchedShape& patched) {
  const TriangleMesh& mesh = patched.input;
  const double reach = BEYOND_RIM * rootArea(patched.clean.mesh);
  const auto n = static_cast<int>(input.vertices.rows());
  std::vector<int> rim(patched.vertices, -1);
  for (bool first = true, found = true; found; first = false) {
    found = false;
    std::vector<int> next = rim;
    std::vector<double> distance(rim.size(), std::numeric_limits<double>::infinity());
    for (auto f = input.faces.rows(); f < mesh.faces.rows(); ++f)
      for (int c = 0; c < 3; ++c)
        for (const int other : {mesh.faces(f, (c + 1) % 3), mesh.faces(f, (c + 2) % 3)}) {
          const int i = mesh.faces(f, c) - n, known = other < n ? other : rim[other - n];
          if (i < 0 || rim[i] >= 0 || known < 0) continue;
          const double d = (mesh.vertices.row(n + i) - mesh.vertices.row(known)).norm();
          if (d >= distance[i] || !(first || d < reach)) continue;
          distance[i] = d;
          next[i] = known;
          found = true;
        }
    rim = std::move(next);
  }
  return rim;
}

/// Places and vertices on a side with patches, on the side without.
class WithoutPatches {
 public:
  WithoutPatches(const TriangleMesh& input, const PatchedShape& patched)
      : vertices_(static_cast<int>(input.vertices.rows())),
        faces_(input.faces),
        face_of_(faceOfEachVertex(input.faces, vertices_)),
        rim_(rimVertices(input, patched)) {}

  int vertex(int v) const { return v < vertices_ ? v : rim_[v - vertices_]; }

  /// A place on a patch is moved to the vertex beside it.
  SurfacePoint place(const SurfacePoint& given) const {
    if (given.vertex < 0 || (given.vertex < vertices_ && given.face < faces_.rows())) return given;
    const int beside = vertex(given.vertex);
    return beside < 0 ? SurfacePoint() : placeOfVertex(faces_, face_of_, beside);
  }

  void trimRows(Correspondence& correspondence) const {
    correspondence.on_target.resize(vertices_);
    correspondence.confidence.conservativeResize(vertices_);
  }

  void trimPlaces(Correspondence& correspondence) const {
    for (std::size_t v = 0; v < correspondence.on_target.size(); ++v) {
      correspondence.on_target[v] = place(correspondence.on_target[v]);
      if (correspondence.on_target[v].vertex < 0)
        correspondence.confidence[static_cast<Eigen::Index>(v)] = 0;
    }
  }

  int vertexCount() const { return vertices_; }

 private:
  int vertices_;
  const Faces& faces_;
  std::vector<int> face_of_, rim_;
};

void trim(const WithoutPatches& rows,
          const WithoutPatches& places,
          Correspondence& correspondence) {
  if (correspondence.on_target.empty()) return;
  rows.trimRows(correspondence);
  places.trimPlaces(correspondence);
}

/// Whether most faces of a surface look the other way after others were added behind them.
bool isTurnedRound(const CleanMesh& before, const CleanMesh& after) {
  int alike = 0;
  for (std::size_t f = 0; f < before.face_turned.size(); ++f)
    if (before.face_on_main[f] != 0 && after.face_on_main[f] != 0)
      alike += before.face_turned[f] == after.face_turned[f] ? 1 : -1;
  return alike < 0;
}

/// Cleans a side after surface was put in.
void cleanAgain(const CleanMesh& before, PatchedShape& patched) {
  patched.clean = cleanMesh(patched.input);
  // More may be known of its outside now than was before, and than is of the other side's.
  if (isTurnedRound(before, patched.clean)) turnOver(patched.clean);
}

/// What was given, and what was done with it.
ShapeSummary summaryWithout(const GivenShape& given,
                            const PatchedShape& shape,
                            const ShapeSummary& patched) {
  ShapeSummary summary = withMeasured(summarize(given), patched);
  summary.patched_holes = shape.holes;
  summary.joined_pieces = shape.pieces;
  summary.parted_contacts = shape.contacts;
  return summary;
}

}  // namespace

PatchedShape withPatches(const TriangleMesh& input, const CleanMesh& clean) {
  // In a frame and an order of its own, so that the patches do not depend on those it came in.
  const Pose pose = poseOf(clean.mesh);
  const CleanMesh ordered = inOrder(clean, pose);
  const HolePatches patches = patchHoles(posed(ordered.mesh, pose));
  PatchedShape patched{
      input, clean, static_cast<int>(patches.vertices.rows()), patches.holes, patches.rim_length};
  if (patches.holes == 0) return patched;
  const auto n = input.vertices.rows(), m = input.faces.rows();
  const auto of_clean = static_cast<int>(clean.mesh.vertices.rows());
  patched.input.vertices.conservativeResize(n + patches.vertices.rows(), 3);
  patched.input.vertices.bottomRows(patches.vertices.rows()) = pose.outOf(patches.vertices);
  patched.input.faces.conservativeResize(m + patches.faces.rows(), 3);
  for (Eigen::Index f = 0; f < patches.faces.rows(); ++f)
    for (int c = 0; c < 3; ++c) {
      const int v = patches.faces(f, c);
      patched.input.faces(m + f, c) =
          v < of_clean ? ordered.input_vertex[v] : static_cast<int>(n) + v - of_clean;
    }
  cleanAgain(clean, patched);
  return patched;
}

PatchedShape withPatches(const TriangleMesh& input, const PartedSurface& parted) {
  if (parted.contacts == 0) return withPatches(input, parted.clean);
  // The numbers of faces stay; a face of one corner is dropped in cleaning.
  TriangleMesh open = input;
  for (Eigen::Index f = 0; f < open.faces.rows(); ++f)
    if (parted.gone[f] != 0) open.faces.row(f).setConstant(open.faces(f, 0));
  PatchedShape patched = withPatches(open, parted.clean);
  patched.contacts = parted.contacts;
  return patched;
}

PatchedShape withBridges(const TriangleMesh& input, const CleanMesh& clean) {
  PatchedShape joined{input, clean};
  if (clean.pieces.faces.rows() == 0) return joined;
  const Pose pose = poseOf(clean.mesh);
  const auto n = clean.mesh.vertices.rows(), m = input.faces.rows();
  const Bridges bridges =
      bridgePieces(withPieces(posed(clean.mesh, pose), posed(clean.pieces, pose)));
  joined.pieces = bridges.pieces;
  if (bridges.pieces == 0) return joined;
  joined.input.faces.conservativeResize(m + bridges.faces.rows(), 3);
  for (Eigen::Index f = 0; f < bridges.faces.rows(); ++f)
    for (int c = 0; c < 3; ++c) {
      const int v = bridges.faces(f, c);
      joined.input.faces(m + f, c) =
          v < n ? clean.input_vertex[v] : clean.piece_vertex[v - static_cast<int>(n)];
    }
  cleanAgain(clean, joined);
  return joined;
}

void leaveOutPatches(const GivenShape& source,
                     const PatchedShape& source_patched,
                     const GivenShape& target,
                     const PatchedShape& target_patched,
                     RegistrationResult& result) {
  if (source_patched.input.faces.rows() == source.input.faces.rows() &&
      target_patched.input.faces.rows() == target.input.faces.rows())
    return;
  const WithoutPatches on_source(source.input, source_patched),
      on_target(target.input, target_patched);
  trim(on_source, on_target, result.correspondence);
  if (result.deformed.rows() > 0) result.deformed.conservativeResize(on_source.vertexCount(), 3);
  if (result.back) {
    trim(on_target, on_source, result.back->correspondence);
    measureMiss(source, target.input, result.correspondence, *result.back);
  }
  for (AlternativeSummary& alternative : result.alternatives) {
    trim(on_source, on_target, alternative.correspondence);
    if (alternative.target_vertex.empty()) continue;
    alternative.target_vertex.resize(on_source.vertexCount());
    for (int& v : alternative.target_vertex)
      if (v >= 0) v = on_target.vertex(v);
  }
  result.source = summaryWithout(source, source_patched, result.source);
  result.target = summaryWithout(target, target_patched, result.target);
  if (result.status == Status::REGISTERED) result.message = mappedMessage(result);
}

}  // namespace posture
