// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/completion/whole_source.h"

#include <posture/core/error.h>
#include <posture/deformation/completion.h>
#include <posture/deformation/extend_deformation.h>

#include "refined/refinement/refined_result.h"
#include "sides/pose.h"
#include <optional>
#include <utility>

namespace posture {
namespace {

bool touchesPatch(const GivenShape& given, const Eigen::RowVector3i& face) {
  return given.isPatch(face[0]) || given.isPatch(face[1]) || given.isPatch(face[2]);
}

Correspondence matchesOf(const TriangleMesh& source, const FullMap& map) {
  const std::size_t n = map.places.size();
  Correspondence matches{std::vector<SurfacePoint>(n), roundTripConfidence(source, map.pair.maps)};
  for (std::size_t v = 0; v < n; ++v)
    if (map.without_partner[v] == 0)
      matches.on_target[v] = {
          map.pair.maps.forward[v], map.places[v].face, map.places[v].barycentric};
  return matches;
}

/// The faces of the full mesh that are not part of a face at a patch's vertices.
Faces withoutPatches(const GivenShape& given, const RefinedShape& shape) {
  std::vector<int> own;
  for (int f = 0; f < shape.full.faces.rows(); ++f)
    if (!touchesPatch(given,
                      given.clean.mesh.faces.row(shape.parts.empty() ? f : shape.parts[f].face)))
      own.push_back(f);
  return shape.full.faces(own, Eigen::all);
}

/// Vertices of the full mesh that are in patches alone.
std::vector<char> inNoFace(const Faces& faces, Eigen::Index vertices) {
  std::vector<char> none(vertices, 1);
  for (int v : faces.reshaped()) none[v] = 0;
  return none;
}

/// What has no partner, or one in a hole that was closed: a patch is flatter than the body.
std::vector<char> withoutOwnPartner(const GivenShape& target,
                                    const Faces& faces,
                                    const FullMap& map) {
  std::vector<char> without = map.without_partner;
  for (std::size_t v = 0; v < without.size(); ++v)
    if (touchesPatch(target, faces.row(map.places[v].face))) without[v] = 1;
  return without;
}

/// Lays what is on pieces of the target there; what is beside them has no partner, and vertices put
/// into faces at either lie as the rest does.
void layOnPieces(const GivenShape& given,
                 const RefinedShape& shape,
                 const Pose& target_pose,
                 const OnPieces& on_pieces,
                 Points& places,
                 std::vector<char>& without) {
  const auto own = given.clean.mesh.vertices.rows();
  std::vector<char> concerned(own, 0);
  for (int v : on_pieces.vertex) concerned[v] = 1;
  for (int v : on_pieces.in_gap) concerned[v] = 1;
  if (!shape.parts.empty())
    for (Eigen::Index f = 0; f < shape.full.faces.rows(); ++f) {
      const auto corners = given.clean.mesh.faces.row(shape.parts[f].face);
      if (concerned[corners[0]] == 0 && concerned[corners[1]] == 0 && concerned[corners[2]] == 0)
        continue;
      for (int v : shape.full.faces.row(f))
        if (v >= own) without[v] = 1;
    }
  places(on_pieces.vertex, Eigen::all) = target_pose.into(on_pieces.places);
  for (int v : on_pieces.vertex) without[v] = 0;
  for (int v : on_pieces.in_gap) without[v] = 1;
}

/// First what was given, as patches say nothing of how it lies; then patches, as it goes.
Points extended(const TriangleMesh& whole,
                const Faces& own,
                const std::vector<char>& without,
                Points places) {
  places = extendDeformation({whole.vertices, own}, std::move(places), without);
  if (own.rows() == whole.faces.rows()) return places;
  return extendDeformation(whole, std::move(places), inNoFace(own, whole.vertices.rows()));
}

/// None where the source has no shape to encode, all in one line, or the map leads nowhere.
std::optional<Points> completed(const PosedSide& source,
                                const RefinedShape& scaled,
                                const PosedSide& target,
                                const FullMap& map,
                                const OnPieces& on_pieces) {
  const TriangleMesh &whole = scaled.full, &onto = target.shape.full;
  if (!map.pair.bent_a.allFinite()) return std::nullopt;
  Completion completion;
  try {
    completion = completeDeformation(whole, map.pair.bent_a, matchesOf(whole, map), onto);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (!completion.places.allFinite()) return std::nullopt;
  std::vector<char> without = withoutOwnPartner(target.given, onto.faces, map);
  layOnPieces(source.given, scaled, target.pose, on_pieces, completion.places, without);
  return extended({completion.scale * whole.vertices, whole.faces},
                  withoutPatches(source.given, scaled),
                  without,
                  std::move(completion.places));
}

}  // namespace

Points placesOfWhole(const PosedSide& source,
                     const RefinedShape& scaled,
                     const PosedSide& target,
                     const FullMap& map,
                     const OnPieces& on_pieces) {
  if (std::optional<Points> places = completed(source, scaled, target, map, on_pieces))
    return std::move(*places);
  Points places = map.pair.bent_a;
  places(on_pieces.vertex, Eigen::all) = target.pose.into(on_pieces.places);
  return places;
}

Points restLaid(const GivenShape& source, const RegistrationResult& result) {
  const CleanMesh& clean = source.clean;
  const TriangleMesh rest{result.scale * clean.mesh.vertices, clean.mesh.faces};
  std::vector<char> without;
  for (int v : clean.input_vertex) without.push_back(result.correspondence.on_target[v].vertex < 0);
  const Points places =
      extendDeformation(rest, result.deformed(clean.input_vertex, Eigen::all), without);
  Points laid = placesOfInput(source,
                              rest,
                              std::vector<char>(without.size(), 1),
                              places,
                              result.scale * source.input.vertices);
  // What has a counterpart keeps its place, loose pieces among them.
  for (Eigen::Index v = 0; v < laid.rows(); ++v)
    if (result.correspondence.on_target[v].vertex >= 0) laid.row(v) = result.deformed.row(v);
  return laid;
}

}  // namespace posture
