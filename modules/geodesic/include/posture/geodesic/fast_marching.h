// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <memory>
#include <vector>

namespace posture {

/// The distances from one source over a mesh, and the way each of them came. A field that was
/// marched before, and not written to since, may be marched again: that saves its allocations and
/// costs only what the two fronts reach.
struct GeodesicField {
  GeodesicField();
  ~GeodesicField();
  GeodesicField(GeodesicField&&) noexcept;
  GeodesicField& operator=(GeodesicField&&) noexcept;

  std::vector<double> distance;  ///< n, in mesh units; infinity where not reached
  /// n: the vertex the front came from, -1 at the source; a neighbour, or behind an obtuse corner
  /// one that becomes a neighbour where faces are unfolded.
  std::vector<int> predecessor;
  std::vector<int> order;  ///< vertices reached, by increasing distance

 private:
  friend class FastMarching;
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

/// Geodesic distances on triangle meshes by fast marching (Kimmel and Sethian 1998), with obtuse
/// corners split by unfolding their neighbours and fronts propagated as circles around a virtual
/// source (Novotni and Klein 2002), which is exact in the plane. Any triangle soup will do:
/// non-manifold edges carry the front on all their sides. O(n) a source; on a mesh so uneven that
/// most vertices lie within a small part of its extent, or of its longest edge, up to O(n log n).
///
/// const members may be called from several threads, each with a field of its own.
class FastMarching {
 public:
  explicit FastMarching(const TriangleMesh& mesh);
  ~FastMarching();
  FastMarching(FastMarching&&) noexcept;
  FastMarching& operator=(FastMarching&&) noexcept;

  /// Distances to every vertex.
  /// \throws std::invalid_argument  no such vertex.
  void march(int source, GeodesicField& field) const;

  /// As march(), but stops when all of `goals` have their distance.
  void marchUntil(int source, const std::vector<int>& goals, GeodesicField& field) const;

  /// Lowers `distance` (n, infinity where nothing was reached so far) to the distance from `source`
  /// wherever that is less; `nearest` (n) becomes `label` there. The front does not leave the
  /// source's Voronoi cell; `field` has that cell.
  void marchWithin(int source,
                   int label,
                   std::vector<double>& distance,
                   std::vector<int>& nearest,
                   GeodesicField& field) const;

  int vertexCount() const;

 private:
  struct Graph;
  std::unique_ptr<const Graph> graph_;
};

}  // namespace posture
