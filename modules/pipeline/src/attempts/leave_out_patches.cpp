// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts/leave_out_patches.h"

#include <posture/mesh/areas.h>
#include <posture/mesh/corners.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/position_of.h>

#include "answer/shared_verdict.h"
#include "refined/completion/way_back.h"
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// How far beyond the rim of a hole, in square roots of the area, a place may lie and still be
/// taken for one on it: maps of surfaces with holes are off by 0.011 to 0.015 in the mean.
constexpr double BEYOND_RIM = 0.015;

/// Gives vertices of patches that have none a rim vertex: of those that their neighbours are, or
/// have, the nearest, if it is less than `reach` away.
/// \param input  `mesh` without patches, whose vertices and faces come first there.
/// \return whether any got one
bool goOnFromRim(const TriangleMesh& input,
                 const TriangleMesh& mesh,
                 double reach,
                 std::vector<int>& rim) {
  const auto n = static_cast<int>(input.vertices.rows());
  std::vector<int> next = rim;
  std::vector<double> distance(rim.size(), reach);
  for (auto f = input.faces.rows(); f < mesh.faces.rows(); ++f)
    for (int c = 0; c < 3; ++c)
      for (const int other : {mesh.faces(f, (c + 1) % 3), mesh.faces(f, (c + 2) % 3)}) {
        const int i = mesh.faces(f, c) - n, known = other < n ? other : rim[other - n];
        if (i < 0 || rim[i] >= 0 || known < 0) continue;
        const double d = (mesh.vertices.row(n + i) - mesh.vertices.row(known)).norm();
        if (!(d < distance[i])) continue;
        distance[i] = d;
        next[i] = known;
      }
  std::swap(rim, next);
  return rim != next;
}

/// For the vertices of patches a vertex of the input at the rim beside them: an edge away, or near
/// enough; -1: none.
std::vector<int> rimVertices(const TriangleMesh& input, const PatchedShape& patched) {
  std::vector<int> rim(patched.patch_vertices, -1);
  double reach = std::numeric_limits<double>::infinity();
  while (goOnFromRim(input, patched.input, reach, rim))
    reach = BEYOND_RIM * rootArea(patched.clean.mesh);
  return rim;
}

/// Places and vertices on a side with patches, on the side without.
class WithoutPatches {
 public:
  WithoutPatches(const TriangleMesh& input, const PatchedShape& patched)
      : patched_(patched.input),
        reach_(std::max(meanEdgeLength(patched.clean.mesh),
                        BEYOND_RIM * rootArea(patched.clean.mesh))),
        vertices_(static_cast<int>(input.vertices.rows())),
        faces_(input.faces),
        face_of_(faceOfEachVertex(input.faces, vertices_)),
        rim_(rimVertices(input, patched)) {}

  int vertex(int v) const { return v < vertices_ ? v : rim_[v - vertices_]; }

  /// A place on a patch or a strip is moved to the vertex beside it, if there is one.
  SurfacePoint place(const SurfacePoint& given) const {
    if (given.vertex < 0 || (given.vertex < vertices_ && given.face < faces_.rows())) return given;
    const int beside = vertex(given.vertex);
    if (beside < 0 || (beside == given.vertex && !isNear(given, beside))) return {};
    return placeOfVertex(faces_, face_of_, beside);
  }

  void trimRows(Correspondence& correspondence) const {
    correspondence.on_target.resize(vertices_);
    correspondence.confidence.conservativeResize(vertices_);
  }

  void trimPlaces(Correspondence& correspondence) const {
    for (std::size_t v = 0; v < correspondence.on_target.size(); ++v) {
      correspondence.on_target[v] = place(correspondence.on_target[v]);
      if (correspondence.on_target[v].vertex < 0) dropRow(correspondence, v);
    }
  }

  int vertexCount() const { return vertices_; }

 private:
  /// Strips may be much wider than an edge.
  bool isNear(const SurfacePoint& given, int v) const {
    return (positionOf(patched_, given) - patched_.vertices.row(v)).norm() <= reach_;
  }

  const TriangleMesh& patched_;
  double reach_;
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

/// What was given, and what was done with it.
ShapeSummary summaryWithout(const GivenShape& given,
                            const PatchedShape& shape,
                            const ShapeSummary& patched) {
  ShapeSummary summary = withMeasured(summarize(given), patched);
  summary.patched_holes = shape.patched_holes;
  summary.joined_pieces = shape.joined_pieces;
  summary.parted_contacts = shape.parted_contacts;
  return summary;
}

}  // namespace

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
}

}  // namespace posture
