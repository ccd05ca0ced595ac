// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/registration/impl/isometric_correspondence_estimation.hpp>
#include <posture/registration/impl/isometric_registration.hpp>

#include <gtest/gtest.h>

#include "registration/pcl_bodies.h"
#include "support/bodies.h"

namespace posture {
namespace {

// Neither is precompiled.
TEST(OtherPointTypes, pointsInDoublePrecisionMatrices) {
  using Registration = IsometricRegistration<pcl::PointXYZRGBA, pcl::PointXYZRGBA, double>;
  const auto source = test::toCloud<pcl::PointXYZRGBA>(test::body(0, 2000).mesh.vertices);
  const auto target = test::toCloud<pcl::PointXYZRGBA>(test::body(1, 2000).mesh.vertices);
  for (std::size_t i = 0; i < source->size(); ++i) (*source)[i].rgba = static_cast<unsigned>(i);
  Registration registration;
  registration.setInputSource(source);
  registration.setInputTarget(target);
  pcl::PointCloud<pcl::PointXYZRGBA> output;
  registration.align(output);
  EXPECT_TRUE(registration.hasConverged()) << registration.getMessage();
  double before = 0, miss = 0;
  for (std::size_t i = 0; i < output.size(); ++i) {
    before += ((*source)[i].getVector3fMap() - (*target)[i].getVector3fMap()).norm();
    miss += (output[i].getVector3fMap() - (*target)[i].getVector3fMap()).norm();
    EXPECT_EQ(output[i].rgba, i);
  }
  EXPECT_LT(miss, before / 2);
  const Eigen::Matrix4d T_target_source = registration.getFinalTransformation();
  EXPECT_NEAR((T_target_source.topLeftCorner<3, 3>().determinant()), 1, 1e-12);
}

TEST(OtherPointTypes, correspondences) {
  IsometricCorrespondenceEstimation<pcl::PointXYZRGBA, pcl::PointXYZRGBA> estimation;
  estimation.setInputSource(pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGBA>>());
  estimation.setInputTarget(test::toCloud<pcl::PointXYZRGBA>(test::body(0, 1000).mesh.vertices));
  pcl::Correspondences matches(3);
  estimation.determineCorrespondences(matches);
  EXPECT_TRUE(matches.empty());
}

}  // namespace
}  // namespace posture
