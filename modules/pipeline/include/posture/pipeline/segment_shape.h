// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>
#include <posture/segmentation/rigid_segments.h>

#include <vector>

namespace posture {

/// Near-rigid parts of a shape as it was given.
struct ShapeSegments {
  RigidSegments parts;  ///< of `surface`; motions in the frames of the shapes as given
  CleanMesh surface;    ///< main surface of the mesh, given or laid through the points
  /// Part of each vertex (point) as given. Loose pieces belong to the part next to them. -1: a
  /// point that was not seen, an outlier, or a vertex or point of a floor or a wall.
  std::vector<int> label;
  /// One vector a pose, one number a part: root mean square distance of its vertices from where its
  /// motion has them, in the unit of the pose.
  std::vector<std::vector<double>> residual;
};

/// Parts that hold over all poses a shape was registered to.
/// \param poses  registrations with `source` as their source.
/// \throws InputError  as cleanMesh; std::invalid_argument  no pose, or of another source.
ShapeSegments segmentShape(const Shape& source, const std::vector<RegistrationResult>& poses);

}  // namespace posture
