// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/pipeline/segment_shape.h>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <sensor_msgs/PointCloud2.h>
#include <string>
#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

namespace posture::app {

/// A side as it came, and as the library takes it; a mesh comes without normals.
struct SideView {
  const sensor_msgs::PointCloud2& message;
  const Shape& shape;
};

/// The source deformed: its message, points and normals moved, under the header of the target.
sensor_msgs::PointCloud2 registeredCloud(const SideView& source,
                                         const SideView& target,
                                         const RegistrationResult& result);

/// Fields x, y, z, rgb, and of each point its counterpart: `target` (number of a point; -1: none)
/// and `confidence` (0 to 1).
sensor_msgs::PointCloud2 coloredSource(const SideView& source, const RegistrationResult& result);

/// Fields x, y, z, rgb; where the way back was asked for also `source` and `confidence`.
sensor_msgs::PointCloud2 coloredTarget(const SideView& source,
                                       const SideView& target,
                                       const RegistrationResult& result);

/// Lines are thinned evenly to this many: more is neither drawn smoothly nor told apart by the eye.
inline constexpr int MOST_LINES = 2000;

/// Lines from points of the source, as if they were given in the target's frame, to their
/// counterparts, in the colours of their places.
visualization_msgs::Marker correspondenceLines(const SideView& source,
                                               const SideView& target,
                                               const RegistrationResult& result);

/// Points of the source, a marker and a colour for each near-rigid part, behind one that clears
/// what was shown before. No segments: the latter alone.
visualization_msgs::MarkerArray segmentMarkers(const SideView& source,
                                               const RegistrationResult& result,
                                               const ShapeSegments* segments);

/// OK: registered; WARN: undecided. Without the name of the node, as the next.
diagnostic_msgs::DiagnosticStatus outcome(const RegistrationResult& result,
                                          const ShapeSegments* segments,
                                          double seconds);

/// ERROR, with the reason.
diagnostic_msgs::DiagnosticStatus failure(const std::string& message);

}  // namespace posture::app
