// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edit_mesh.h"

#include <algorithm>

namespace posture::synthesis {
namespace {

bool has(const std::array<int, 3>& face, int v) {
  return face[0] == v || face[1] == v || face[2] == v;
}

/// The corner that follows v around the face.
int after(const std::array<int, 3>& face, int v) {
  return face[0] == v ? face[1] : face[1] == v ? face[2] : face[0];
}

}  // namespace

EditMesh::EditMesh(const TriangleMesh& mesh) : faces_of_(mesh.vertices.rows()) {
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) point_.emplace_back(mesh.vertices.row(i));
  for (Eigen::Index i = 0; i < mesh.faces.rows(); ++i)
    addFace({mesh.faces(i, 0), mesh.faces(i, 1), mesh.faces(i, 2)});
}

int EditMesh::numVertices() const {
  int count = 0;
  for (int v = 0; v < numSlots(); ++v) count += isAlive(v);
  return count;
}

std::vector<std::pair<int, int>> EditMesh::edges() const {
  std::vector<std::pair<int, int>> edges;
  for (int v = 0; v < numSlots(); ++v)
    for (int f : faces_of_[v]) {
      const int w = after(face_[f], v);  // each edge leads from v to w in one of its faces
      if (v < w) edges.emplace_back(v, w);
    }
  return edges;
}

std::vector<int> EditMesh::neighbours(int v) const {
  std::vector<int> around;
  for (int f : faces_of_[v]) around.push_back(after(face_[f], v));
  return around;
}

std::array<int, 2> EditMesh::facesOfEdge(int a, int b) const {
  std::array<int, 2> found = {-1, -1};  // the face that runs a -> b, the one that runs b -> a
  for (int f : faces_of_[a])
    if (has(face_[f], b)) found[after(face_[f], a) == b ? 0 : 1] = f;
  return found;
}

std::array<int, 2> EditMesh::oppositeCorners(int a, int b) const {
  const auto [f, g] = facesOfEdge(a, b);
  if (f < 0 || g < 0) return {-1, -1};
  return {after(face_[f], b), after(face_[g], a)};
}

Vec3 EditMesh::crossProduct(const Face& f) const {
  return (point_[f[1]] - point_[f[0]]).cross(point_[f[2]] - point_[f[0]]);
}

Vec3 EditMesh::areaNormal(int v) const {
  Vec3 sum = Vec3::Zero();
  for (int f : faces_of_[v]) sum += crossProduct(face_[f]);
  return sum;
}

Vec3 EditMesh::areaCentroid(int v) const {
  Vec3 sum = Vec3::Zero();
  double weight = 1e-30;
  for (int f : faces_of_[v]) {
    const double area = crossProduct(face_[f]).norm();
    sum += area / 3 * (point_[face_[f][0]] + point_[face_[f][1]] + point_[face_[f][2]]);
    weight += area;
  }
  return sum / weight;
}

void EditMesh::addFace(const Face& corners) {
  for (int v : corners) faces_of_[v].push_back(static_cast<int>(face_.size()));
  face_.push_back(corners);
}

void EditMesh::forget(int v, int face) {
  auto& faces = faces_of_[v];
  faces.erase(std::find(faces.begin(), faces.end(), face));
}

void EditMesh::dropFace(int face) {
  for (int v : face_[face]) forget(v, face);
  face_[face] = {-1, -1, -1};
}

void EditMesh::replaceCorner(int face, int old_corner, int new_corner) {
  *std::find(face_[face].begin(), face_[face].end(), old_corner) = new_corner;
  forget(old_corner, face);
  faces_of_[new_corner].push_back(face);
}

int EditMesh::split(int a, int b, const Vec3& at) {
  const int middle = numSlots();
  point_.push_back(at);
  faces_of_.emplace_back();
  const auto [c, d] = oppositeCorners(a, b);
  const auto [f, g] = facesOfEdge(a, b);
  replaceCorner(f, b, middle);
  replaceCorner(g, b, middle);
  addFace({middle, b, c});
  addFace({b, middle, d});
  return middle;
}

/// Would a face of v that does not touch `other` turn by more than some 75 degrees?
bool EditMesh::collapseTurnsOver(int v, int other, const Vec3& at) const {
  for (int f : faces_of_[v]) {
    if (has(face_[f], other)) continue;
    const int b = after(face_[f], v), c = after(face_[f], b);
    const Vec3 before = (point_[b] - point_[v]).cross(point_[c] - point_[v]);
    const Vec3 now = (point_[b] - at).cross(point_[c] - at);
    if (now.dot(before) <= 0.25 * now.norm() * before.norm()) return true;
  }
  return false;
}

bool EditMesh::collapse(int keep, int gone, const Vec3& at) {
  const auto [c, d] = oppositeCorners(keep, gone);
  if (c < 0 || valence(c) <= 3 || valence(d) <= 3) return false;
  const std::vector<int> around = neighbours(keep);
  int common = 0;
  for (int v : neighbours(gone)) common += std::count(around.begin(), around.end(), v) > 0;
  if (common != 2) return false;
  if (collapseTurnsOver(keep, gone, at) || collapseTurnsOver(gone, keep, at)) return false;
  const auto [f, g] = facesOfEdge(keep, gone);
  dropFace(f);
  dropFace(g);
  const std::vector<int> moved = faces_of_[gone];
  for (int face : moved) replaceCorner(face, gone, keep);
  point_[keep] = at;
  return true;
}

bool EditMesh::flip(int a, int b) {
  const auto [c, d] = oppositeCorners(a, b);
  if (c < 0 || valence(a) <= 3 || valence(b) <= 3) return false;
  if (facesOfEdge(c, d) != std::array<int, 2>{-1, -1}) return false;
  const Face first = {a, d, c}, second = {d, b, c};
  const Vec3 normal = crossProduct({a, b, c}) + crossProduct({b, a, d});
  for (const Face& face : {first, second}) {
    const Vec3 turned = crossProduct(face);
    if (turned.dot(normal) <= 0.5 * turned.norm() * normal.norm()) return false;
  }
  const auto [f, g] = facesOfEdge(a, b);
  dropFace(f);
  dropFace(g);
  addFace(first);
  addFace(second);
  return true;
}

TriangleMesh EditMesh::take() const {
  TriangleMesh mesh;
  std::vector<int> number(point_.size(), -1);
  mesh.vertices.resize(numVertices(), 3);
  int count = 0;
  for (int v = 0; v < numSlots(); ++v)
    if (isAlive(v)) mesh.vertices.row(number[v] = count++) = point_[v];
  int rows = 0;
  for (const Face& face : face_) rows += face[0] >= 0;
  mesh.faces.resize(rows, 3);
  int row = 0;
  for (const Face& face : face_)
    if (face[0] >= 0) mesh.faces.row(row++) << number[face[0]], number[face[1]], number[face[2]];
  return mesh;
}

}  // namespace posture::synthesis
