// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/mesh/vertex_neighbors.h>

#include <Eigen/Geometry>

#include <vector>

namespace posture {

/// The surface in a pose, on which a part of it may slide.
class PosedSurface {
 public:
  struct Place {
    Eigen::Vector3d at, normal;
  };

  /// \param faces  outlives this.
  PosedSurface(const Points& places, const Faces& faces);

  const Points& places() const { return places_; }

  /// The place nearest to `point`, found downhill along the edges from vertex `from`, which becomes
  /// the vertex nearest to it.
  Place nearest(const Eigen::Vector3d& point, int& from) const;

 private:
  Points places_, normals_;
  const Faces& faces_;
  VertexFaces faces_at_;
};

struct WeighedVertex {
  int vertex;
  double weight;
};

struct SlidingFit {
  Eigen::Isometry3d motion;
  double misfit;  ///< weighted sum of squared distances, those along the surface times `along`
};

struct SlidingOptions {
  double along;  ///< what distance along the surface counts
  int rounds;    ///< at most
  bool robust;   ///< what is several times farther off than most counts little (Geman and McClure)
};

/// The rigid motion that best brings vertices onto the posed surface. Where on it they lie is known
/// less well than that they lie on it: distance along the surface, from where a vertex is said to
/// be, counts `along` times what distance from the surface counts (Gauss-Newton, with places and
/// planes looked for anew in each round).
/// \param start  a motion near the one looked for.
SlidingFit slideOnto(const PosedSurface& surface,
                     const Points& rest,
                     const std::vector<WeighedVertex>& of,
                     const Eigen::Isometry3d& start,
                     const SlidingOptions& options);

}  // namespace posture
