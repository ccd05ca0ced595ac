// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// A face of a split mesh, as a part of the face it was cut out of.
struct FacePart {
  int face = -1;  ///< of the mesh given
  /// Column k: the place of corner k in that face, in barycentric coordinates. Times those of a
  /// place in the part, they are those of the same place in the face.
  Eigen::Matrix3d corners = Eigen::Matrix3d::Identity();
};

/// More vertices on the same surface.
struct SplitMesh {
  TriangleMesh mesh;            ///< the vertices given come first
  std::vector<FacePart> parts;  ///< one a face
};

/// Splits the longest edge of all in its middle, and with it every face beside it, again and again
/// until there are `count` vertices. The surface stays as it is, angles never fall below half of
/// the least they were (Rosenberg and Stenger 1975), and what is split does not depend on the order
/// of vertices or faces. An edge stays if its middle is no new place: that of an end, or of the
/// third corner of a face without area.
/// \param mesh  each face with three different corners: see cleanMesh().
SplitMesh splitLongEdges(const TriangleMesh& mesh, int count);

}  // namespace posture
