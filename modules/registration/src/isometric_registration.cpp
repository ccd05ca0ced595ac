// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/registration/impl/isometric_registration.hpp>

namespace posture {

template class IsometricRegistration<pcl::PointXYZ, pcl::PointXYZ>;
template class IsometricRegistration<pcl::PointXYZI, pcl::PointXYZI>;
template class IsometricRegistration<pcl::PointXYZRGB, pcl::PointXYZRGB>;
template class IsometricRegistration<pcl::PointNormal, pcl::PointNormal>;
template class IsometricRegistration<pcl::PointXYZRGBNormal, pcl::PointXYZRGBNormal>;

}  // namespace posture
