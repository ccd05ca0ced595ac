// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/cut_surface.h"

#include <posture/core/median.h>
#include <posture/core/unions.h>
#include <posture/mesh/half_edge_mesh.h>

#include <algorithm>

namespace posture {
namespace {

/// A face of the surface: tetrahedron 4 t + k is inside, the one across from corner k outside.
class CutFaces {
 public:
  CutFaces(const Points& points,
           const Tetrahedra& tetrahedra,
           const std::vector<char>& inside,
           const Spacing& spacing)
      : tetrahedra_(tetrahedra), inside_(inside), number_(4 * inside.size(), -1) {
    for (int t = 0; t < tetrahedra.size(); ++t)
      for (int k = 0; k < 4; ++k) {
        if (!inside[t] || inside[tetrahedra.beyond[t][k]]) continue;
        const std::array<int, 3> face = tetrahedra.face(t, k);
        if (std::max({face[0], face[1], face[2]}) < points.rows()) sides_.push_back(4 * t + k);
      }
    leaveOutLongFaces(points, spacing);
    for (int f = 0; f < size(); ++f) number_[sides_[f]] = f;
  }

  int size() const { return static_cast<int>(sides_.size()); }

  std::array<int, 3> corners(int f) const { return tetrahedra_.face(sides_[f] / 4, sides_[f] % 4); }

  /// The face reached through the inside around the edge opposite corner `apex`, or -1.
  int across(int f, int apex) const {
    int t = sides_[f] / 4, behind = tetrahedra_.corners[t][sides_[f] % 4], leaving = apex;
    while (true) {
      const int k = cornerOf(t, leaving), next = tetrahedra_.beyond[t][k];
      if (!inside_[next]) return number_[4 * t + k];
      leaving = behind;
      behind = tetrahedra_.corners[next][tetrahedra_.mirror(t, k)];
      t = next;
    }
  }

 private:
  /// Faces longer than the reach of the tangent-plane triangles bridge what has no points.
  void leaveOutLongFaces(const Points& points, const Spacing& spacing) {
    const std::vector<double> along = spacingAlong(points);
    const auto isTooLong = [&](int side) {
      const std::array<int, 3> face = tetrahedra_.face(side / 4, side % 4);
      double h = 0, length = 0;
      for (int k = 0; k < 3; ++k) {
        h = std::max({h, spacing.at[face[k]], along[face[k]]});
        length = std::max(length, (points.row(face[k]) - points.row(face[(k + 1) % 3])).norm());
      }
      return length > 4 * h;
    };
    sides_.erase(std::remove_if(sides_.begin(), sides_.end(), isTooLong), sides_.end());
  }

  /// Median edge of the faces at and next to each point. On thin parts the ball of nearest points,
  /// which Spacing counts, holds both sheets.
  std::vector<double> spacingAlong(const Points& points) const {
    const auto medians = [&](const auto& valueAt) {
      std::vector<std::vector<double>> values(points.rows());
      for (int f = 0; f < size(); ++f) {
        const std::array<int, 3> face = corners(f);
        for (int k = 0; k < 3; ++k)
          for (int end : {(k + 1) % 3, (k + 2) % 3})
            values[face[k]].push_back(valueAt(face[k], face[end]));
      }
      std::vector<double> middle(values.size());
      for (std::size_t i = 0; i < values.size(); ++i)
        if (!values[i].empty()) middle[i] = lowerMedian(std::move(values[i]));
      return middle;
    };
    const std::vector<double> edges =
        medians([&](int i, int j) { return (points.row(i) - points.row(j)).norm(); });
    return medians([&](int, int j) { return edges[j]; });
  }

  int cornerOf(int t, int vertex) const {
    const std::array<int, 4>& c = tetrahedra_.corners[t];
    return static_cast<int>(std::find(c.begin(), c.end(), vertex) - c.begin());
  }

  const Tetrahedra& tetrahedra_;
  const std::vector<char>& inside_;
  std::vector<int> number_;  ///< of the face at each side of a tetrahedron, or -1
  std::vector<int> sides_;
};

/// For each corner 3 f + k a number shared by the corners of one fan.
std::vector<int> fans(const CutFaces& faces) {
  const int count = 3 * faces.size();
  Unions sets(count);
  for (int f = 0; f < faces.size(); ++f) {
    const std::array<int, 3> own = faces.corners(f);
    for (int k = 0; k < 3; ++k) {
      const int g = faces.across(f, own[k]);
      if (g < f) continue;
      const std::array<int, 3> other = faces.corners(g);
      for (int end : {(k + 1) % 3, (k + 2) % 3}) {
        const auto same = std::find(other.begin(), other.end(), own[end]);
        sets.join(3 * f + end, 3 * g + static_cast<int>(same - other.begin()));
      }
    }
  }
  return sets.roots();
}

}  // namespace

PointSurface cutSurface(const Points& points,
                        const Tetrahedra& tetrahedra,
                        const std::vector<char>& inside,
                        const Spacing& spacing) {
  const CutFaces faces(points, tetrahedra, inside, spacing);
  const std::vector<int> fan = fans(faces);
  std::vector<int> vertex_of_fan(fan.size(), -1), point;
  TriangleMesh mesh{{}, Faces(faces.size(), 3)};
  for (int f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      int& vertex = vertex_of_fan[fan[3 * f + k]];
      if (vertex < 0) {
        vertex = static_cast<int>(point.size());
        point.push_back(faces.corners(f)[k]);
      }
      mesh.faces(f, k) = vertex;
    }
  mesh.vertices = points(point, Eigen::all);
  // A fan that comes twice through one edge is left.
  ManifoldMesh manifold = cutNonManifold(mesh);
  PointSurface surface{std::move(manifold.mesh), {}};
  for (int v : manifold.original_vertex) surface.point.push_back(point[v]);
  return surface;
}

}  // namespace posture
