// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/shapes.h"

#include <posture/core/rng.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace posture::test {

TriangleMesh grid(int columns, int rows, double width, double height) {
  TriangleMesh mesh;
  mesh.vertices.resize((columns + 1) * (rows + 1), 3);
  mesh.faces.resize(2 * columns * rows, 3);
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c)
      mesh.vertices.row(r * (columns + 1) + c) << width * c / columns, height * r / rows, 0.0;
  int face = 0;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int a = r * (columns + 1) + c, b = a + 1, d = a + columns + 1, e = d + 1;
      if ((r + c) % 2 == 0) {
        mesh.faces.row(face++) << a, b, e;
        mesh.faces.row(face++) << a, e, d;
      } else {
        mesh.faces.row(face++) << a, b, d;
        mesh.faces.row(face++) << b, e, d;
      }
    }
  return mesh;
}

TriangleMesh sphere(int levels) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Eigen::Vector3d> v = {{-1, g, 0},
                                    {1, g, 0},
                                    {-1, -g, 0},
                                    {1, -g, 0},
                                    {0, -1, g},
                                    {0, 1, g},
                                    {0, -1, -g},
                                    {0, 1, -g},
                                    {g, 0, -1},
                                    {g, 0, 1},
                                    {-g, 0, -1},
                                    {-g, 0, 1}};
  for (auto& p : v) p.normalize();
  std::vector<Eigen::Vector3i> f = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middle;
    const auto split = [&](int a, int b) {
      const auto [entry, is_new] =
          middle.try_emplace(std::minmax(a, b), static_cast<int>(v.size()));
      if (is_new) v.push_back((v[a] + v[b]).normalized());
      return entry->second;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const auto& t : f) {
      const int a = split(t[0], t[1]), b = split(t[1], t[2]), c = split(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
    }
    f = finer;
  }
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<int>(v.size()), 3);
  mesh.faces.resize(static_cast<int>(f.size()), 3);
  for (std::size_t i = 0; i < v.size(); ++i) mesh.vertices.row(i) = v[i];
  for (std::size_t i = 0; i < f.size(); ++i) mesh.faces.row(i) = f[i];
  return mesh;
}

TriangleMesh bentStrip(int columns, int rows, double length, double width, double angle) {
  TriangleMesh mesh = grid(columns, rows, length, width);
  if (angle == 0) return mesh;
  const double radius = length / angle;
  for (int i = 0; i < mesh.vertices.rows(); ++i) {
    const double phi = mesh.vertices(i, 0) / radius;
    mesh.vertices(i, 0) = radius * std::sin(phi);
    mesh.vertices(i, 2) = radius * (1 - std::cos(phi));
  }
  return mesh;
}

TriangleMesh torus(int around, int across, double ring_radius, double tube_radius) {
  constexpr double TURN = 2 * 3.141592653589793;
  TriangleMesh mesh{Points(around * across, 3), Faces(2 * around * across, 3)};
  int face = 0;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = TURN * i / around, v = TURN * j / across;
      const double r = ring_radius + tube_radius * std::cos(v);
      mesh.vertices.row(i * across + j) << r * std::cos(u), r * std::sin(u),
          tube_radius * std::sin(v);
      const int a = i * across + j, b = (i + 1) % around * across + j,
                c = (i + 1) % around * across + (j + 1) % across, d = i * across + (j + 1) % across;
      mesh.faces.row(face++) << a, b, c;
      mesh.faces.row(face++) << a, c, d;
    }
  return mesh;
}

TriangleMesh fused(const TriangleMesh& mesh, int a, int b) {
  // The ring around a vertex, as its faces run.
  const auto ringOf = [&](int center) {
    std::map<int, int> next;
    for (int f = 0; f < mesh.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k)
        if (mesh.faces(f, k) == center)
          next[mesh.faces(f, (k + 1) % 3)] = mesh.faces(f, (k + 2) % 3);
    std::vector<int> ring{next.begin()->first};
    while (next[ring.back()] != ring.front()) ring.push_back(next[ring.back()]);
    return ring;
  };
  const std::vector<int> one = ringOf(a);
  std::vector<int> other = ringOf(b);
  std::reverse(other.begin(), other.end());
  const auto apart = [&](int v, int w) {
    return (mesh.vertices.row(v) - mesh.vertices.row(w)).norm();
  };
  std::rotate(other.begin(),
              std::min_element(other.begin(),
                               other.end(),
                               [&](int v, int w) { return apart(v, one[0]) < apart(w, one[0]); }),
              other.end());
  std::vector<Eigen::RowVector3i> faces;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    if ((mesh.faces.row(f).array() != a && mesh.faces.row(f).array() != b).all())
      faces.emplace_back(mesh.faces.row(f));
  for (std::size_t i = 0, j = 0; i < one.size() || j < other.size();) {
    const int p = one[i % one.size()], p_next = one[(i + 1) % one.size()],
              q = other[j % other.size()], q_next = other[(j + 1) % other.size()];
    if (j == other.size() || (i < one.size() && apart(p_next, q) < apart(p, q_next))) {
      faces.emplace_back(p, p_next, q);
      ++i;
    } else {
      faces.emplace_back(p, q_next, q);
      ++j;
    }
  }
  TriangleMesh result{mesh.vertices, Faces(faces.size(), 3)};
  for (std::size_t f = 0; f < faces.size(); ++f) result.faces.row(f) = faces[f];
  return result;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both{Points(a.vertices.rows() + b.vertices.rows(), 3),
                    Faces(a.faces.rows() + b.faces.rows(), 3)};
  both.vertices << a.vertices, b.vertices;
  both.faces << a.faces, b.faces.array() + static_cast<int>(a.vertices.rows());
  return both;
}

TriangleMesh shifted(TriangleMesh mesh, const Eigen::RowVector3d& by) {
  mesh.vertices.rowwise() += by;
  return mesh;
}

TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh loose{Points(mesh.faces.size(), 3), Faces(mesh.faces.rows(), 3)};
  for (int f = 0; f < mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      loose.faces(f, k) = 3 * f + k;
      loose.vertices.row(3 * f + k) = mesh.vertices.row(mesh.faces(f, k));
    }
  return loose;
}

Points randomPoints(int count, std::uint64_t seed) {
  Rng rng(seed);
  Points points(count, 3);
  for (int i = 0; i < points.size(); ++i) points.data()[i] = rng.normal();
  return points;
}

Matrix pairwise(const Points& points) {
  Matrix distances(points.rows(), points.rows());
  for (int i = 0; i < points.rows(); ++i)
    distances.col(i) = (points.rowwise() - points.row(i)).rowwise().norm();
  return distances;
}

}  // namespace posture::test
