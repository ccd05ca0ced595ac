// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/completion/target_part.h"

#include <posture/mesh/corners.h>
#include <posture/mesh/nearest_on_faces.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/mesh/weld.h>

#include <algorithm>
#include <utility>

namespace posture {
namespace {

/// In edges: what is farther from a piece than that, and less than twice as far, lies beyond it.
constexpr double BEYOND = 4;

/// Faces between the first vertices at each place.
TriangleMesh between(TriangleMesh mesh, const std::vector<int>& first) {
  for (int& v : mesh.faces.reshaped()) v = first[v];
  return mesh;
}

}  // namespace

std::vector<int> farthestPoints(const Points& points, int first, int count) {
  std::vector<int> chosen{first};
  Vector distance = (points.rowwise() - points.row(first)).rowwise().norm();
  while (static_cast<int>(chosen.size()) < count) {
    int farthest = 0;
    if (!(distance.maxCoeff(&farthest) > 0)) break;
    chosen.push_back(farthest);
    distance = distance.cwiseMin((points.rowwise() - points.row(farthest)).rowwise().norm());
  }
  return chosen;
}

double fitAt(double distance) {
  const double miss = distance / ON_SURFACE;
  return 1 / (1 + miss * miss);
}

PieceTarget::PieceTarget(TriangleMesh surface,
                         Points vertex_normals,
                         double mean_edge,
                         double body_size)
    : first(weld(surface.vertices)),
      mesh(between(std::move(surface), first)),
      normals(std::move(vertex_normals)),
      neighbors(mesh.faces, static_cast<int>(first.size())),
      faces_around(mesh.faces, static_cast<int>(first.size())),
      on_faces(cornersOfFaces(mesh.faces, static_cast<int>(first.size()))),
      edge(mean_edge),
      size(body_size) {}

TargetPart::TargetPart(const PieceTarget& surface, std::vector<int> vertices)
    : surface_(surface), vertex_(std::move(vertices)), counts_(surface.mesh.vertices.rows(), 0) {
  const auto does_not_count = [&](int v) {
    return surface.first[v] != v || surface.on_faces[v] == 0;
  };
  vertex_.erase(std::remove_if(vertex_.begin(), vertex_.end(), does_not_count), vertex_.end());
  for (int v : vertex_) counts_[v] = 1;
  if (!vertex_.empty()) index_.emplace(surface.mesh.vertices(vertex_, Eigen::all));
}

TargetPart::Near TargetPart::nearest(const Eigen::RowVector3d& place) const {
  const TriangleMesh& mesh = surface_.mesh;
  Near near;
  near.at.vertex = vertex_[index_->nearest(place.transpose()).index];
  near.place = mesh.vertices.row(near.at.vertex);
  NearestPlace best;
  lookAround(
      mesh.vertices, mesh.faces, surface_.faces_around, near.at.vertex, place.transpose(), best);
  if (best.face >= 0) {
    near.place = best.place.transpose();
    near.at.face = best.face;
    near.at.barycentric = best.barycentric;
  }
  near.distance = (near.place - place).norm() / surface_.edge;
  return near;
}

std::vector<TargetPart::Near> TargetPart::nearest(const Piece& piece,
                                                  const Eigen::Isometry3d& motion) const {
  const Points places = moved(motion, piece.points);
  std::vector<Near> near;
  for (int i = 0; i < places.rows(); ++i) {
    near.push_back(nearest(places.row(i)));
    const Eigen::Vector3d normal = motion.linear() * piece.normals.row(i).transpose();
    near.back().same_way = normal.dot(surface_.normals.row(near.back().at.vertex)) >= 0;
  }
  return near;
}

double TargetPart::goingOn(const Piece& piece, const Eigen::Isometry3d& motion) const {
  const Points& vertices = surface_.mesh.vertices;
  const Points places = moved(motion, piece.points);
  const PointIndex on_piece(places);
  std::vector<int> rim;
  for (int i = 0; i < places.rows(); ++i)
    if (piece.on_rim[i] != 0) rim.push_back(i);
  if (rim.size() == piece.on_rim.size()) return 0;
  const std::optional<PointIndex> on_rim =
      rim.empty() ? std::nullopt : std::make_optional<PointIndex>(places(rim, Eigen::all));
  // Between the points of a coarse piece its surface goes on, too.
  const double beyond = BEYOND * std::max(edge(), piece.edge);
  const auto isNearRim = [&](int i) {
    return on_rim && on_rim->nearest(places.row(i).transpose()).distance < beyond;
  };
  // From where the piece lies on, as far as it is near.
  std::vector<int> reached;
  std::vector<char> seen(vertices.rows(), 0);
  const auto reach = [&](int v) {
    if (seen[v] != 0 || counts_[v] == 0) return;
    seen[v] = 1;
    reached.push_back(v);
  };
  for (const Near& near : nearest(piece, motion))
    if (near.distance < ON_SURFACE && near.same_way) reach(near.at.vertex);
  int ends = 0, goes_on = 0;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const int v = reached[k];
    const PointIndex::Neighbor near = on_piece.nearest(vertices.row(v).transpose());
    if (near.distance > 2 * beyond) continue;
    if (near.distance > beyond) ++(isNearRim(near.index) ? ends : goes_on);
    std::for_each(surface_.neighbors.begin(v), surface_.neighbors.end(v), reach);
  }
  return goes_on == 0 ? 0 : static_cast<double>(goes_on) / (ends + goes_on);
}

std::vector<int> TargetPart::spread(const Eigen::RowVector3d& around,
                                    double distance,
                                    int count) const {
  std::vector<int> within;
  Eigen::Index first = 0;
  double least = distance;
  for (int v : vertex_) {
    const double d = (surface_.mesh.vertices.row(v) - around).norm();
    if (!(d < distance) || !(surface_.normals.row(v).squaredNorm() > 0)) continue;
    if (d < least) {
      least = d;
      first = static_cast<Eigen::Index>(within.size());
    }
    within.push_back(v);
  }
  if (within.empty()) return within;
  std::vector<int> chosen;
  for (int i :
       farthestPoints(surface_.mesh.vertices(within, Eigen::all), static_cast<int>(first), count))
    chosen.push_back(within[i]);
  return chosen;
}

}  // namespace posture
