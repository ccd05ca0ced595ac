// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <cstdint>
#include <sensor_msgs/PointCloud2.h>
#include <string>
#include <vector>

namespace posture::app {

/// Points of a message in the order of its data, and its normals (normal_x, normal_y, normal_z)
/// where it has them, both of FLOAT32 or FLOAT64 at any place. Where height and width are above 1
/// the points are the grid of a depth image.
/// \throws InputError  no field x, y or z, one of another type, or data that do not fit the layout;
/// the message begins with "has".
PointCloud cloudOf(const sensor_msgs::PointCloud2& message);

/// Fields x, y, z, then normals and colours where the cloud has them, in single precision.
sensor_msgs::PointCloud2 messageOf(const PointCloud& cloud, const std_msgs::Header& header);

/// The message with its points, and its normals where it has them, in other places; all else is
/// kept. \param normals  n x 3, or 0 x 3 where the message has none.
sensor_msgs::PointCloud2 moved(sensor_msgs::PointCloud2 message,
                               const Points& points,
                               const Points& normals);

/// Gives every point one more number. \param values  one a point.
void appendField(sensor_msgs::PointCloud2& message,
                 const std::string& name,
                 const std::vector<float>& values);
void appendField(sensor_msgs::PointCloud2& message,
                 const std::string& name,
                 const std::vector<std::int32_t>& values);

}  // namespace posture::app
