// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/pose.h"

#include <posture/core/matrix_of.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/moment_axes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace posture {
namespace {

/// In units of a body of area one: a ten-thousandth of an edge of the finest meshes, ten digits
/// above what turning in double precision changes.
constexpr double GRID = 0x1p-20;

}  // namespace

Points Pose::into(const Points& points) const {
  return unit * ((points.rowwise() - center) * axes);
}

Points Pose::outOf(const Points& points) const {
  return (points / unit * axes.transpose()).rowwise() + center;
}

Pose poseOf(const TriangleMesh& mesh) {
  const Vector area = faceAreas(mesh);
  Points middles(mesh.faces.rows(), 3);
  for (int f = 0; f < middles.rows(); ++f)
    middles.row(f) = (mesh.vertices.row(mesh.faces(f, 0)) + mesh.vertices.row(mesh.faces(f, 1)) +
                      mesh.vertices.row(mesh.faces(f, 2))) /
                     3;
  Pose pose;
  pose.unit = 1 / std::sqrt(area.sum());
  pose.center = area.transpose() * middles / area.sum();
  middles.rowwise() -= pose.center;
  pose.axes = momentAxes(middles, area);
  return pose;
}

TriangleMesh posed(const TriangleMesh& mesh, const Pose& pose) {
  return {(pose.into(mesh.vertices).array() / GRID).round() * GRID, mesh.faces};
}

CleanMesh inOrder(const CleanMesh& clean, const Pose& pose) {
  const Points places = posed(clean.mesh, pose).vertices;
  const int n = static_cast<int>(places.rows());
  std::vector<int> order(n), number(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    for (int k = 0; k < 3; ++k)
      if (places(a, k) != places(b, k)) return places(a, k) < places(b, k);
    return a < b;
  });
  CleanMesh ordered = clean;
  for (int i = 0; i < n; ++i) {
    number[order[i]] = i;
    ordered.mesh.vertices.row(i) = clean.mesh.vertices.row(order[i]);
    ordered.input_vertex[i] = clean.input_vertex[order[i]];
  }
  for (int& v : ordered.clean_vertex) v = number[v];
  std::vector<std::array<int, 3>> faces(clean.mesh.faces.rows());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int k = 0; k < 3; ++k) faces[f][k] = number[clean.mesh.faces(static_cast<int>(f), k)];
    std::rotate(
        faces[f].begin(), std::min_element(faces[f].begin(), faces[f].end()), faces[f].end());
  }
  std::sort(faces.begin(), faces.end());
  ordered.mesh.faces = matrixOf<Faces>(faces);
  return ordered;
}

}  // namespace posture
