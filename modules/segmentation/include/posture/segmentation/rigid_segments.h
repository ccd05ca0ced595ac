// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <Eigen/Geometry>

#include <vector>

namespace posture {

/// Parts of a surface that move almost rigidly, in all poses at once (section 6.2).
struct RigidSegments {
  std::vector<int> label;       ///< n: part of each vertex, the largest part first; -1: in no face
  std::vector<int> face_label;  ///< m; the faces of a part are joined by edges
  int count = 0;
  std::vector<double> scale;  ///< one a pose: a length at rest times this is one in the pose
  /// One vector a pose, one motion a part: it takes scale times a place at rest to the pose.
  std::vector<std::vector<Eigen::Isometry3d>> motion;
  /// Adjacent parts turn by more than this against each other, in radians: what was found to
  /// separate joints from the rest.
  double least_turn = 0;
};

/// Clusters the faces of a mesh by how they move.
///
/// That a vertex lies on the surface of a pose is known well, where on it much less: registrations
/// err along the surface by several times what they err across it. The motion of a set of faces is
/// therefore the one that brings it best onto the pose's surface, along which it may slide at
/// little cost. What two sets cost to move as one follows from their motions and from how stiffly
/// each is held by its shape; it is told as a turn about the middle of their border, the angle
/// that costs as much about the axis that costs most.
///
/// 1. The surface is cut into some 200 patches of equal size. Turns between adjacent patches are
///    small inside parts and large at joints; Otsu's threshold (1979) of their cube roots, which
///    brings values spread over orders of magnitude into two compact classes, separates the two.
///    Seven tenths of it are asked for: a joint bends over several patches.
/// 2. From single faces on, the two adjacent clusters are merged whose common rigid motion costs
///    least in squared distance, weighted by area (Ward 1963): small clusters go first, and to the
///    neighbour that moves most rigidly with them. From 150 clusters on they may slide, and only
///    those are merged whose turn is below the threshold or explained by noise, or of which one
///    has less than half a per cent of the area.
/// 3. The motion of a part is fitted once more with less weight on faces that bend, as next to
///    joints.
/// \param rest  all its vertices finite, those in no face as well.
/// \param poses  each n x 3: the mesh's vertices in that pose, in any unit.
/// \throws std::invalid_argument  no pose, sizes that do not agree, a mesh without area, or
///         places of a pose that are no numbers.
RigidSegments segmentRigidParts(const TriangleMesh& rest, const std::vector<Points>& poses);

}  // namespace posture
