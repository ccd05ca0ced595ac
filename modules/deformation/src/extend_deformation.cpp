// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/apply_deformation.h>
#include <posture/deformation/arap.h>
#include <posture/deformation/extend_deformation.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/vertex_neighbors.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// So far around free vertices the surface has a say: the first ring has rotations of its own,
/// which its whole cells tell.
constexpr int RINGS = 2;

/// Known places do not give way: many times what the edges of a vertex weigh, cotangents of which
/// the largest are some tens.
constexpr double HOLD = 1e4;

constexpr int ITERATIONS = 50;

/// The part of a surface around some of its vertices.
class Surroundings {
 public:
  Surroundings(const TriangleMesh& whole, const VertexFaces& faces_at, const std::vector<int>& of)
      : whole_(whole) {
    std::vector<int> vertices = of;
    for (int ring = 0; ring < RINGS; ++ring) {
      faces_.clear();
      for (int v : vertices) faces_.insert(faces_.end(), faces_at.begin(v), faces_at.end(v));
      sortUnique(faces_);
      vertices.clear();
      for (int f : faces_)
        for (int v : whole.faces.row(f)) vertices.push_back(v);
      sortUnique(vertices);
    }
  }

  /// Some of it as a mesh. \param keep  of a face.
  template <class Keep>
  std::pair<TriangleMesh, std::vector<int>> mesh(const Keep& keep) const {
    std::vector<int> kept, vertex;
    for (int f : faces_)
      if (keep(whole_.faces.row(f))) kept.push_back(f);
    Faces faces = whole_.faces(kept, Eigen::all);
    for (int v : faces.reshaped()) vertex.push_back(v);
    sortUnique(vertex);
    for (int& v : faces.reshaped())
      v = static_cast<int>(std::lower_bound(vertex.begin(), vertex.end(), v) - vertex.begin());
    return {{whole_.vertices(vertex, Eigen::all), faces}, vertex};
  }

 private:
  static void sortUnique(std::vector<int>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  const TriangleMesh& whole_;
  std::vector<int> faces_;
};

void layRegion(const TriangleMesh& rest,
               const VertexFaces& faces_at,
               const std::vector<char>& is_free,
               const std::vector<int>& region,
               Points& places) {
  const Surroundings surroundings(rest, faces_at, region);
  const auto [near, vertex] = surroundings.mesh([](const auto&) { return true; });
  const auto [around, known] = surroundings.mesh([&](const Eigen::RowVector3i& face) {
    return is_free[face[0]] == 0 && is_free[face[1]] == 0 && is_free[face[2]] == 0;
  });
  if (known.empty() || !(surfaceArea(around) > 0)) return;

  // From where the surface around takes them: what lies where nothing told may be folded.
  Points start = places(vertex, Eigen::all);
  const Points taken_along =
      applyDeformation(around, places(known, Eigen::all), rest.vertices(vertex, Eigen::all));
  const Laplacian laplacian = cotangentLaplacian(near);
  const double softness = 1 / laplacian.mass.sum();  // the same in any unit
  Vector hold = HOLD / softness * laplacian.mass.cwiseInverse();
  for (int i = 0; i < hold.size(); ++i)
    if (is_free[vertex[i]] != 0) {
      hold[i] = 0;
      start.row(i) = taken_along.row(i);
    }
  const Arap arap(near, laplacian);
  Points laid;
  try {
    laid = arap.pull(start, start, arap.attract(softness, hold), ITERATIONS);
  } catch (const TornSurface&) {  // it stays where it is
    return;
  }
  if (!laid.allFinite()) return;
  for (int i = 0; i < hold.size(); ++i)
    if (hold[i] == 0) places.row(vertex[i]) = laid.row(i);
}

}  // namespace

Points extendDeformation(const TriangleMesh& rest,
                         Points places,
                         const std::vector<char>& is_free) {
  const auto n = rest.vertices.rows();
  require(places.rows() == n && static_cast<Eigen::Index>(is_free.size()) == n,
          "extendDeformation: one place and one mark a vertex");
  const VertexFaces faces_at(rest.faces, static_cast<int>(n));
  // Regions with a single known vertex between them are one.
  const VertexNeighbors near = VertexNeighbors(rest.faces, static_cast<int>(n)).withinTwoEdges();
  for (const std::vector<int>& region : markedParts(near, is_free))
    layRegion(rest, faces_at, is_free, region, places);
  return places;
}

}  // namespace posture
