// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/registration/impl/isometric_correspondence_estimation.hpp>

namespace posture {

template class IsometricCorrespondenceEstimation<pcl::PointXYZ, pcl::PointXYZ>;
template class IsometricCorrespondenceEstimation<pcl::PointXYZI, pcl::PointXYZI>;
template class IsometricCorrespondenceEstimation<pcl::PointXYZRGB, pcl::PointXYZRGB>;
template class IsometricCorrespondenceEstimation<pcl::PointNormal, pcl::PointNormal>;
template class IsometricCorrespondenceEstimation<pcl::PointXYZRGBNormal, pcl::PointXYZRGBNormal>;

}  // namespace posture
