// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>

#include <memory>

namespace posture {

/// Nearest places on a mesh: a tree of boxes around its faces.
class MeshLocator {
 public:
  /// \pre  the mesh has faces, and outlives this.
  explicit MeshLocator(const TriangleMesh& mesh);
  ~MeshLocator();

  struct Place {
    SurfacePoint on_mesh;
    double distance = 0;
  };

  /// May be called from several threads. Of equally near faces the first.
  /// \throws std::invalid_argument  the square of the distance is not finite.
  Place nearest(const Eigen::Vector3d& point) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace posture
