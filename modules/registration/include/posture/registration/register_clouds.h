// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>
#include <posture/deformation/apply_deformation.h>
#include <posture/pipeline/register_shapes.h>

#include <pcl/Vertices.h>
#include <pcl/correspondence.h>

#include <cstddef>
#include <string>
#include <vector>

namespace posture {

/// One side of a registration as PCL's classes have it: the points of a cloud that take part.
struct CloudSide {
  PointCloud cloud;         ///< n points, in the order of the indices
  std::vector<int> number;  ///< n: of each in the cloud it is from
  std::size_t total = 0;    ///< how many points that cloud has
  std::string fault;        ///< what is wrong with the indices, in words; empty: nothing
  /// In the numbers of that cloud; empty: points alone. Polygons of more than three corners are cut
  /// by cutPolygon(); triangles with a corner that takes no part, or is not finite, are left out.
  std::vector<pcl::Vertices> polygons;
};

/// What both PCL classes of this module hand on.
struct RegisteredClouds {
  /// Rows are those of the source's cloud, vertices those of the target's. `face` counts the
  /// triangles the target's polygons were cut into; of points alone it is one of target_scan. Where
  /// there is no answer: UNDECIDED, why, and all else empty.
  RegistrationResult result;
  DeformedSurface surface;       ///< the source's; no vertices: there is no answer
  Points normals;                ///< those of the source's cloud, turned
  pcl::Correspondences matches;  ///< in the numbers of the clouds; distances squared, as deformed
  /// Those whose target point is matched to the same source point on the way back, if asked for.
  pcl::Correspondences reciprocal_matches;
  /// Rotation and translation of least squares over the matches; the identity where there is none.
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();

  bool answered() const { return surface.rest.vertices.rows() > 0; }
};

/// registerShapes() for clouds with indices and polygons. What is wrong with the data is the
/// message of a result without an answer; what the observer throws is thrown on, and so is running
/// out of memory.
RegisteredClouds registerClouds(const CloudSide& source,
                                const CloudSide& target,
                                const RegistrationOptions& options,
                                const Observer& observer);

/// Points taken along with the source's surface, their normals turned. Points that are not finite
/// stay as they are, and so do normals that are not finite or zero.
/// \pre  clouds.answered().
PointCloud deformed(const RegisteredClouds& clouds, PointCloud points);

/// The mean squared distance from finite points to the nearest finite one of the target, over those
/// for which it is at most `max_range`, squared as well; the largest double where there is none.
double meanSquaredDistance(const Points& points, const Points& target, double max_range);

}  // namespace posture
