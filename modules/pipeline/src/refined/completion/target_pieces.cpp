// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/completion/target_pieces.h"

#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/mesh/vertex_neighbors.h>

#include "refined/completion/target_part.h"
#include <algorithm>
#include <optional>

namespace posture {
namespace {

/// In mean edges: what lies farther beyond the rim of a piece is no more on it.
constexpr double BEYOND_RIM = 1;

/// Vertices of the source's main surface on which the target's does not lie.
std::vector<int> openVertices(const GivenShape& source,
                              const GivenShape& target,
                              const LaidSide& back) {
  const TriangleMesh& mesh = source.clean.mesh;
  const std::vector<char> covered =
      coveredBy(target, back, mesh.vertices, ON_SURFACE * meanEdgeLength(mesh));
  std::vector<int> open;
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    if (!source.isPatch(v) && covered[v] == 0) open.push_back(v);
  return open;
}

/// Which places lie in the box of some points, or no farther from it than `margin`.
std::vector<int> inBoxOf(const Points& points, double margin, const Points& places) {
  const Eigen::RowVector3d low = points.colwise().minCoeff().array() - margin,
                           high = points.colwise().maxCoeff().array() + margin;
  std::vector<int> inside;
  for (int i = 0; i < places.rows(); ++i)
    if ((places.row(i).array() >= low.array()).all() &&
        (places.row(i).array() <= high.array()).all())
      inside.push_back(i);
  return inside;
}

/// The open vertices, not those found, that are joined to those found by edges between open ones.
std::vector<int> beside(const TriangleMesh& mesh,
                        const std::vector<int>& open,
                        const std::vector<int>& found) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const VertexNeighbors neighbors(mesh.faces, n);
  std::vector<char> is_left(n, 0);
  for (int v : open) is_left[v] = 1;
  for (int v : found) is_left[v] = 0;
  std::vector<int> reached = found;
  for (std::size_t i = 0; i < reached.size(); ++i)
    std::for_each(neighbors.begin(reached[i]), neighbors.end(reached[i]), [&](int w) {
      if (is_left[w] == 0) return;
      is_left[w] = 0;
      reached.push_back(w);
    });
  reached.erase(reached.begin(), reached.begin() + static_cast<std::ptrdiff_t>(found.size()));
  return reached;
}

}  // namespace

OnPieces onPieces(const GivenShape& source,
                  const GivenShape& target,
                  const LaidSide& back,
                  const std::vector<PlacedPiece>& placed) {
  OnPieces found;
  if (placed.empty()) return found;
  const std::vector<int> open = openVertices(source, target, back);
  const TriangleMesh& mesh = source.clean.mesh;
  const Points points = mesh.vertices(open, Eigen::all),
               normals = vertexNormals(mesh)(open, Eigen::all);
  const PieceTarget surface = pieceTarget(target);
  const std::vector<char> on_rim = inputRim(target);
  struct Place {
    TargetPart::Near near;
    Eigen::RowVector3d place;
  };
  std::vector<std::optional<Place>> best(open.size());
  for (const PlacedPiece& piece : placed) {
    const TargetPart part(surface, piece.vertices);
    const Points to_target = moved(piece.motion.inverse(), points) / back.scale;
    const std::vector<int> about = inBoxOf(
        target.input.vertices(piece.vertices, Eigen::all), ON_SURFACE * surface.edge, to_target);
    const Piece there{
        to_target(about, Eigen::all), normals(about, Eigen::all) * piece.motion.linear(), 0, {}, 0};
    const std::vector<TargetPart::Near> nearest =
        part.nearest(there, Eigen::Isometry3d::Identity());
    for (std::size_t k = 0; k < about.size(); ++k) {
      const TargetPart::Near& near = nearest[k];
      std::optional<Place>& known = best[about[k]];
      const double farthest = on_rim[near.at.vertex] != 0 ? BEYOND_RIM : ON_SURFACE;
      if (near.distance < farthest && near.same_way &&
          (!known || near.distance < known->near.distance))
        known = Place{near, to_target.row(about[k])};
    }
  }
  found.places.resize(
      std::count_if(best.begin(), best.end(), [](const auto& place) { return place.has_value(); }),
      3);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!best[i]) continue;
    found.places.row(static_cast<Eigen::Index>(found.vertex.size())) = best[i]->place;
    found.vertex.push_back(open[i]);
    found.on_target.push_back(best[i]->near.at);
    found.fit.push_back(fitAt(best[i]->near.distance));
  }
  found.in_gap = beside(mesh, open, found.vertex);
  return found;
}

void addMatches(const GivenShape& source, const OnPieces& on_pieces, LaidSide& laid) {
  struct Match {
    SurfacePoint on_target;
    double confidence = 0;
  };
  std::vector<std::optional<Match>> matches(source.clean.mesh.vertices.rows());
  for (std::size_t i = 0; i < on_pieces.vertex.size(); ++i)
    matches[on_pieces.vertex[i]] = Match{on_pieces.on_target[i], laid.trust * on_pieces.fit[i]};
  for (int v : on_pieces.in_gap) matches[v] = Match{};
  for (int v = 0; v < source.ownVertices(); ++v) {
    const auto& match = matches[source.clean.clean_vertex[v]];
    if (!source.clean.isOnMain(v) || !match) continue;
    laid.correspondence.on_target[v] = match->on_target;
    laid.correspondence.confidence[v] = match->confidence;
  }
}

}  // namespace posture
