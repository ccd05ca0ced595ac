// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/inside_boundary.h"

#include <posture/core/median.h>
#include <posture/core/unions.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/handles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace posture {
namespace {

/// How long faces are, in spacings. Longer ones than LONG bridge gaps, between two hooves, or lie
/// where points are far apart, along a mane: they are left out where they make a handle. Those
/// longer than SURFACE_REACH bridge what has no points.
constexpr double LONG = 2.5;

/// A face of the surface: tetrahedron 4 t + k is inside, the one across from corner k outside.
class BoundaryFaces {
 public:
  BoundaryFaces(const Points& points,
                const Tetrahedra& tetrahedra,
                const std::vector<char>& inside,
                const Spacing& spacing,
                const Points& to_eye)
      : tetrahedra_(tetrahedra), inside_(inside), number_(4 * inside.size(), -1) {
    for (int t = 0; t < tetrahedra.size(); ++t)
      for (int k = 0; k < 4; ++k) {
        if (!inside[t] || inside[tetrahedra.beyond[t][k]]) continue;
        const std::array<int, 3> face = tetrahedra.face(t, k);
        if (std::max({face[0], face[1], face[2]}) < points.rows() &&
            !looksAway(face, points, to_eye))
          sides_.push_back(4 * t + k);
      }
    leaveOutLongest(points, spacing);
    for (int f = 0; f < size(); ++f) number_[sides_[f]] = f;
  }

  int size() const { return static_cast<int>(sides_.size()); }

  std::array<int, 3> corners(int f) const { return tetrahedra_.face(sides_[f] / 4, sides_[f] % 4); }

  bool isLong(int f) const { return length_[f] > LONG; }

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
  void leaveOutLongest(const Points& points, const Spacing& spacing) {
    const std::vector<double> along = spacingAlong(points);
    std::vector<int> sides;
    for (int side : sides_) {
      const std::array<int, 3> face = tetrahedra_.face(side / 4, side % 4);
      double h = 0, length = 0;
      for (int k = 0; k < 3; ++k) {
        h = std::max({h, spacing.at[face[k]], along[face[k]]});
        length = std::max(length, (points.row(face[k]) - points.row(face[(k + 1) % 3])).norm());
      }
      if (length > SURFACE_REACH * h) continue;
      sides.push_back(side);
      length_.push_back(length / h);
    }
    sides_ = std::move(sides);
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
  std::vector<double> length_;  ///< of each face, in spacings
};

/// For each corner 3 f + k a number shared by the corners of one fan.
/// \param kept  of each face, whether it is there.
std::vector<int> fans(const BoundaryFaces& faces, const std::vector<char>& kept) {
  const int count = 3 * faces.size();
  Unions sets(count);
  for (int f = 0; f < faces.size(); ++f) {
    if (kept[f] == 0) continue;
    const std::array<int, 3> own = faces.corners(f);
    for (int k = 0; k < 3; ++k) {
      const int g = faces.across(f, own[k]);
      if (g < f || kept[g] == 0) continue;
      const std::array<int, 3> other = faces.corners(g);
      for (int end : {(k + 1) % 3, (k + 2) % 3}) {
        const auto same = std::find(other.begin(), other.end(), own[end]);
        sets.join(3 * f + end, 3 * g + static_cast<int>(same - other.begin()));
      }
    }
  }
  return sets.roots();
}

PointSurface surfaceOf(const Points& points,
                       const BoundaryFaces& faces,
                       const std::vector<char>& kept) {
  const std::vector<int> fan = fans(faces, kept);
  std::vector<int> vertex_of_fan(fan.size(), -1), point;
  TriangleMesh mesh{{}, Faces(std::count(kept.begin(), kept.end(), 1), 3)};
  Eigen::Index row = 0;
  for (int f = 0; f < faces.size(); ++f) {
    if (kept[f] == 0) continue;
    for (int k = 0; k < 3; ++k) {
      int& vertex = vertex_of_fan[fan[3 * f + k]];
      if (vertex < 0) {
        vertex = static_cast<int>(point.size());
        point.push_back(faces.corners(f)[k]);
      }
      mesh.faces(row, k) = vertex;
    }
    ++row;
  }
  mesh.vertices = points(point, Eigen::all);
  // A fan that comes twice through one edge is left.
  ManifoldMesh manifold = cutNonManifold(mesh);
  PointSurface surface{std::move(manifold.mesh), {}};
  for (int v : manifold.original_vertex) surface.point.push_back(point[v]);
  return surface;
}

/// Long faces next to each other, a list a patch.
std::vector<std::vector<int>> longPatches(const BoundaryFaces& faces) {
  Unions sets(faces.size());
  for (int f = 0; f < faces.size(); ++f) {
    if (!faces.isLong(f)) continue;
    for (int corner : faces.corners(f))
      if (const int g = faces.across(f, corner); g >= 0 && faces.isLong(g)) sets.join(f, g);
  }
  std::map<int, std::vector<int>> patches;
  for (int f = 0; f < faces.size(); ++f)
    if (faces.isLong(f)) patches[sets.root(f)].push_back(f);
  std::vector<std::vector<int>> all;
  all.reserve(patches.size());
  for (auto& [root, patch] : patches) all.push_back(std::move(patch));
  return all;
}

/// Puts patches back that make no handle, by halves. Each look at the handles takes time as the
/// surface does; patches that many looks have not told of, as those of a comb, are left out.
class PutBack {
 public:
  PutBack(const Points& points, const BoundaryFaces& faces, std::vector<char> kept)
      : points_(points), faces_(faces), kept_(std::move(kept)), handles_(handlesOf(kept_)) {}

  using Patch = std::vector<std::vector<int>>::const_iterator;

  void operator()(Patch begin, Patch end) {
    if (begin == end || !mayLook()) return;
    std::vector<char> more = kept_;
    for (Patch patch = begin; patch != end; ++patch)
      for (int f : *patch) more[f] = 1;
    if (handlesOf(more) <= handles_) {
      kept_ = std::move(more);
    } else if (const auto half = (end - begin) / 2; half > 0) {
      (*this)(begin, begin + half);
      (*this)(begin + half, end);
    }
  }

  const std::vector<char>& kept() const { return kept_; }

 private:
  /// Half a minute at most: a look at a million faces takes about two seconds.
  bool mayLook() {
    constexpr double MOST_FACES = 1e7;
    return ++looks_ * static_cast<double>(faces_.size()) < MOST_FACES;
  }

  int handlesOf(const std::vector<char>& kept) const {
    return Handles(surfaceOf(points_, faces_, kept).mesh).count();
  }

  const Points& points_;
  const BoundaryFaces& faces_;
  std::vector<char> kept_;  ///< of each face
  int handles_;
  int looks_ = 0;
};

/// What is left of a bridge hangs on one of its ends: patches that share a point with one that is
/// left out.
void leaveOutFlaps(const BoundaryFaces& faces,
                   const std::vector<std::vector<int>>& patches,
                   std::vector<char>& kept) {
  std::set<int> of_bridges;
  for (const std::vector<int>& patch : patches)
    for (int f : patch)
      if (kept[f] == 0)
        for (int point : faces.corners(f)) of_bridges.insert(point);
  for (const std::vector<int>& patch : patches) {
    const bool touches = std::any_of(patch.begin(), patch.end(), [&](int f) {
      const std::array<int, 3> face = faces.corners(f);
      return std::any_of(
          face.begin(), face.end(), [&](int point) { return of_bridges.count(point) > 0; });
    });
    if (touches)
      for (int f : patch) kept[f] = 0;
  }
}

}  // namespace

bool looksAway(const std::array<int, 3>& face, const Points& points, const Points& to_eye) {
  if (to_eye.rows() == 0) return false;
  const Eigen::RowVector3d a = points.row(face[0]);
  const Eigen::RowVector3d normal = (points.row(face[1]) - a).cross(points.row(face[2]) - a);
  return std::all_of(
      face.begin(), face.end(), [&](int corner) { return normal.dot(to_eye.row(corner)) < 0; });
}

PointSurface boundaryOfInside(const Points& points,
                              const Tetrahedra& tetrahedra,
                              const std::vector<char>& inside,
                              const Spacing& spacing,
                              const Points& to_eye) {
  const BoundaryFaces faces(points, tetrahedra, inside, spacing, to_eye);
  const std::vector<std::vector<int>> patches = longPatches(faces);
  std::vector<char> kept(faces.size());
  for (int f = 0; f < faces.size(); ++f) kept[f] = !faces.isLong(f);
  PutBack put_back(points, faces, std::move(kept));
  put_back(patches.begin(), patches.end());
  kept = put_back.kept();
  leaveOutFlaps(faces, patches, kept);
  return surfaceOf(points, faces, kept);
}

}  // namespace posture
