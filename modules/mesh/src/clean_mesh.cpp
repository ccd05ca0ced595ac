// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/require_mesh.h>

#include <Eigen/Geometry>

#include "weld.h"
#include <algorithm>
#include <array>
#include <limits>
#include <set>

namespace posture {
namespace {

std::vector<Eigen::Vector3i> usableFaces(const Faces& faces,
                                         const std::vector<int>& representative,
                                         CleaningSummary& summary) {
  std::vector<Eigen::Vector3i> usable;
  std::set<std::array<int, 3>> seen;
  for (int f = 0; f < faces.rows(); ++f) {
    const Eigen::Vector3i t(
        representative[faces(f, 0)], representative[faces(f, 1)], representative[faces(f, 2)]);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++summary.degenerate_faces;
      continue;
    }
    std::array<int, 3> corners{t[0], t[1], t[2]};
    std::sort(corners.begin(), corners.end());
    if (seen.insert(corners).second)
      usable.push_back(t);
    else
      ++summary.repeated_faces;
  }
  return usable;
}

Faces toFaces(const std::vector<Eigen::Vector3i>& triangles) {
  Faces faces(triangles.size(), 3);
  for (std::size_t f = 0; f < triangles.size(); ++f) faces.row(f) = triangles[f];
  return faces;
}

bool hasDirectedEdge(const Faces& faces, int face, int from, int to) {
  for (int k = 0; k < 3; ++k)
    if (faces(face, k) == from && faces(face, (k + 1) % 3) == to) return true;
  return false;
}

double signedVolume(const TriangleMesh& mesh, const std::vector<int>& patch) {
  const Eigen::Vector3d origin = mesh.vertices.row(mesh.faces(patch[0], 0));
  double volume = 0;
  for (int f : patch) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.faces(f, 0)).transpose() - origin;
    const Eigen::Vector3d b = mesh.vertices.row(mesh.faces(f, 1)).transpose() - origin;
    const Eigen::Vector3d c = mesh.vertices.row(mesh.faces(f, 2)).transpose() - origin;
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

/// Turns the faces of each patch alike: outwards where the patch is closed, otherwise the way most
/// of its area already faces.
class Orienter {
 public:
  explicit Orienter(TriangleMesh& mesh)
      : mesh_(mesh),
        given_(mesh.faces),
        across_(facesAcross(mesh.faces)),
        areas_(faceAreas(mesh)),
        visited_(mesh.faces.rows(), 0) {}

  /// Returns the number of faces turned round.
  int run() {
    for (int seed = 0; seed < given_.rows(); ++seed) {
      if (visited_[seed]) continue;
      const Patch patch = grow(seed);
      if (patch.closed ? signedVolume(mesh_, patch.faces) < 0 : patch.agreeing < 0)
        for (int f : patch.faces) flip(f);
    }
    int flipped = 0;
    for (int f = 0; f < given_.rows(); ++f) flipped += mesh_.faces.row(f) != given_.row(f);
    return flipped;
  }

 private:
  struct Patch {
    std::vector<int> faces;
    bool closed = true;
    double agreeing = 0;  ///< area that faces as it was given less area that does not
  };

  /// Turns all that can be reached from a face the way that face is.
  Patch grow(int seed) {
    visited_[seed] = 1;
    Patch patch;
    patch.faces.push_back(seed);
    for (std::size_t next = 0; next < patch.faces.size(); ++next) {
      const int f = patch.faces[next];
      patch.agreeing += mesh_.faces.row(f) == given_.row(f) ? areas_[f] : -areas_[f];
      for (int k = 0; k < 3; ++k) {
        const int g = across_(f, k);
        patch.closed = patch.closed && g >= 0;
        if (g < 0 || visited_[g]) continue;
        visited_[g] = 1;
        const int a = given_(f, k), b = given_(f, (k + 1) % 3);
        const bool f_runs_ab = hasDirectedEdge(mesh_.faces, f, a, b);
        if (hasDirectedEdge(mesh_.faces, g, a, b) == f_runs_ab) flip(g);
        patch.faces.push_back(g);
      }
    }
    return patch;
  }

  void flip(int face) { std::swap(mesh_.faces(face, 1), mesh_.faces(face, 2)); }

  TriangleMesh& mesh_;
  const Faces given_, across_;
  const Vector areas_;
  std::vector<char> visited_;
};

/// Of the main surface's area: less is a crumb.
constexpr double LEAST_PIECE = 0.01;

/// Puts the parts other than the main one that are no crumbs into `clean.pieces`.
void keepPieces(const TriangleMesh& welded, const ConnectedParts& parts, CleanMesh& clean) {
  std::vector<Eigen::Vector3i> faces;
  std::vector<int> number(welded.vertices.rows(), -1);
  for (int f = 0; f < welded.faces.rows(); ++f) {
    const int part = parts.of_face[f];
    if (part == parts.largest || parts.area[part] < LEAST_PIECE * parts.area[parts.largest])
      continue;
    faces.emplace_back(welded.faces.row(f));
    for (int& v : faces.back()) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(clean.piece_vertex.size());
        clean.piece_vertex.push_back(v);
      }
      v = number[v];
    }
  }
  clean.pieces = {welded.vertices(clean.piece_vertex, Eigen::all), toFaces(faces)};
  Orienter(clean.pieces).run();
}

/// What rounding leaves between corners in a line, as read or far from the origin.
double areaOfRounding(const Points& vertices) {
  const double extent = (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).norm();
  const double digit = std::numeric_limits<double>::epsilon() * vertices.cwiseAbs().maxCoeff();
  return extent * std::max(1e-12 * extent, 4 * digit);
}

/// Input vertices that are no corner of the main surface follow the clean vertex nearest to them.
void attachLooseVertices(const Points& vertices, CleanMesh& clean) {
  const bool any_loose = std::count(clean.clean_vertex.begin(), clean.clean_vertex.end(), -1) > 0;
  if (!any_loose) return;
  const PointIndex index(clean.mesh.vertices);
  for (int v = 0; v < vertices.rows(); ++v) {
    if (clean.clean_vertex[v] >= 0) continue;
    const int nearest = index.nearest(vertices.row(v)).index;
    clean.clean_vertex[v] = nearest;
    // Not the distance of the index, in whose single precision it may be 0.
    clean.offset[v] = (vertices.row(v) - clean.mesh.vertices.row(nearest)).norm();
  }
}

}  // namespace

CleanMesh cleanMesh(const TriangleMesh& input) {
  const int n = static_cast<int>(input.vertices.rows());
  if (input.faces.rows() == 0) throw InputError("has no faces");
  requireMesh(input);
  CleanMesh clean;
  CleaningSummary& summary = clean.summary;
  const std::vector<int> representative = weld(input.vertices);
  for (int v = 0; v < n; ++v) summary.welded_vertices += representative[v] != v;

  TriangleMesh welded{input.vertices, toFaces(usableFaces(input.faces, representative, summary))};
  if (welded.faces.rows() == 0) throw InputError("has no face with three different corners");
  std::vector<char> referenced(n, 0);
  for (int i = 0; i < input.faces.size(); ++i) referenced[input.faces.data()[i]] = 1;
  summary.unreferenced_vertices =
      static_cast<int>(std::count(referenced.begin(), referenced.end(), 0));

  const ConnectedParts parts = connectedParts(welded);
  summary.components = static_cast<int>(parts.area.size());
  clean.clean_vertex.assign(n, -1);
  clean.offset = Vector::Zero(n);
  std::vector<Eigen::Vector3i> faces;
  for (int f = 0; f < welded.faces.rows(); ++f)
    if (parts.of_face[f] == parts.largest) faces.emplace_back(welded.faces.row(f));
  // Numbered in the order of the input.
  for (const auto& t : faces)
    for (int k = 0; k < 3; ++k) clean.clean_vertex[t[k]] = 0;
  for (int v = 0; v < n; ++v)
    if (clean.clean_vertex[v] == 0) {
      clean.clean_vertex[v] = static_cast<int>(clean.input_vertex.size());
      clean.input_vertex.push_back(v);
    }
  for (int v = 0; v < n; ++v) clean.clean_vertex[v] = clean.clean_vertex[representative[v]];
  for (auto& t : faces)
    for (int k = 0; k < 3; ++k) t[k] = clean.clean_vertex[t[k]];
  for (int v = 0; v < n; ++v)
    summary.loose_vertices += referenced[v] != 0 && clean.clean_vertex[v] < 0;

  clean.mesh.faces = toFaces(faces);
  clean.mesh.vertices = input.vertices(clean.input_vertex, Eigen::all);
  if (!(parts.area[parts.largest] > areaOfRounding(clean.mesh.vertices)))
    throw InputError("has only faces without area");
  summary.flipped_faces = Orienter(clean.mesh).run();
  for (const Edge& e : meshEdges(clean.mesh.faces)) summary.non_manifold_edges += e.faces > 2;
  attachLooseVertices(input.vertices, clean);
  keepPieces(welded, parts, clean);
  return clean;
}

int cornerPlaces(const TriangleMesh& mesh, int vertices) {
  const std::vector<int> first = weld(mesh.vertices.topRows(vertices));
  std::vector<char> is_corner(vertices, 0);
  for (int v : mesh.faces.reshaped())
    if (v < vertices) is_corner[first[v]] = 1;
  return static_cast<int>(std::count(is_corner.begin(), is_corner.end(), 1));
}

}  // namespace posture
