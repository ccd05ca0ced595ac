// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/apply_deformation.h>
#include <posture/deformation/arap.h>
#include <posture/deformation/extend_deformation.h>
#include <posture/mesh/edges.h>

#include <vector>

namespace posture {
namespace {

/// So far around free vertices the surface has a say: the first ring has rotations of its own,
/// which its whole cells tell.
constexpr int RINGS = 2;

/// In 1 / squared mean edges: known places do not give way.
constexpr double HOLD = 100;

constexpr int ITERATIONS = 50;

/// The faces within some rings of the vertices marked.
Faces facesNear(const Faces& faces, std::vector<char> marked, int rings) {
  std::vector<int> near;
  for (int ring = 0; ring < rings; ++ring) {
    near.clear();
    for (int f = 0; f < faces.rows(); ++f)
      if (marked[faces(f, 0)] != 0 || marked[faces(f, 1)] != 0 || marked[faces(f, 2)] != 0)
        near.push_back(f);
    for (int f : near)
      for (int v : faces.row(f)) marked[v] = 1;
  }
  return faces(near, Eigen::all);
}

Faces facesWithout(const Faces& faces, const std::vector<char>& marked) {
  std::vector<int> rest;
  for (int f = 0; f < faces.rows(); ++f)
    if (marked[faces(f, 0)] == 0 && marked[faces(f, 1)] == 0 && marked[faces(f, 2)] == 0)
      rest.push_back(f);
  return faces(rest, Eigen::all);
}

/// Some faces of a mesh and the vertices at them.
struct PartOfMesh {
  PartOfMesh(const Points& vertices, const Faces& faces) : mesh{{}, faces} {
    std::vector<int> number(vertices.rows(), -1);
    for (int& corner : mesh.faces.reshaped()) {
      if (number[corner] < 0) {
        number[corner] = static_cast<int>(vertex.size());
        vertex.push_back(corner);
      }
      corner = number[corner];
    }
    mesh.vertices = vertices(vertex, Eigen::all);
  }

  TriangleMesh mesh;
  std::vector<int> vertex;  ///< of the whole mesh
};

}  // namespace

Points extendDeformation(const TriangleMesh& rest,
                         Points places,
                         const std::vector<char>& is_free) {
  const auto n = rest.vertices.rows();
  require(places.rows() == n && static_cast<Eigen::Index>(is_free.size()) == n,
          "extendDeformation: one place and one mark a vertex");
  const Faces faces = facesNear(rest.faces, is_free, RINGS);
  const PartOfMesh near(rest.vertices, faces), around(rest.vertices, facesWithout(faces, is_free));
  if (around.vertex.empty()) return places;

  // From where the surface around takes them: what lies where nothing told may be folded.
  std::vector<int> free;
  for (int v : near.vertex)
    if (is_free[v] != 0) free.push_back(v);
  const Points taken_along = applyDeformation(
      around.mesh, places(around.vertex, Eigen::all), rest.vertices(free, Eigen::all));
  places(free, Eigen::all) = taken_along;

  Vector held = Vector::Ones(static_cast<Eigen::Index>(near.vertex.size()));
  for (int i = 0; i < held.size(); ++i)
    if (is_free[near.vertex[i]] != 0) held[i] = 0;
  const Points start = places(near.vertex, Eigen::all);
  const double edge = meanEdgeLength(near.mesh);
  const Arap arap(near.mesh, cotangentLaplacian(near.mesh));
  const Points laid = arap.pull(start, start, arap.attract(HOLD / (edge * edge), held), ITERATIONS);
  for (int i = 0; i < held.size(); ++i)
    if (held[i] == 0) places.row(near.vertex[i]) = laid.row(i);
  return places;
}

}  // namespace posture
