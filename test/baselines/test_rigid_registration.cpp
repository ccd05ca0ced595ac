// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/baselines/rigid_registration.h>
#include <posture/core/error.h>
#include <posture/core/rng.h>
#include <posture/mesh/normals.h>
#include <posture/synthesis/articulated_body.h>
#include <posture/synthesis/rigid_pair.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pcl/console/print.h>

#include "support/files.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <omp.h>

namespace posture {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

const Vector3d AXIS = Vector3d(2, -1, 3).normalized();

/// A body in a pose that is its own mirror image nowhere, in some unit and far from the origin.
PointCloud makeCloud(int tessellation, int pose = 3) {
  BodyOptions options;
  options.pose = pose;
  options.vertices = 1500;
  options.tessellation = tessellation;
  const TriangleMesh mesh = makeBody(options).mesh;
  PointCloud cloud;
  cloud.points = (250 * mesh.vertices).rowwise() + Eigen::RowVector3d(4000, -3000, 500);
  cloud.normals = vertexNormals(mesh);
  return cloud;
}

const PointCloud& body() {
  static const PointCloud BODY = makeCloud(0);
  return BODY;
}

constexpr double BODY_LENGTH = 250;

PointCloud moved(const PointCloud& cloud, const Isometry3d& motion) {
  PointCloud result = cloud;
  result.points =
      (cloud.points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
  if (cloud.normals.rows() > 0) result.normals = cloud.normals * motion.linear().transpose();
  return result;
}

/// Turns about the cloud's mean.
Isometry3d turn(const PointCloud& cloud, double angle, const Vector3d& shift) {
  const Vector3d middle = cloud.points.colwise().mean();
  Isometry3d motion = Isometry3d::Identity();
  motion.translate(middle + shift);
  motion.rotate(AngleAxisd(angle, AXIS));
  motion.translate(-middle);
  return motion;
}

/// Mean distance of the moved points from where they belong, over the body's length.
double miss(const Isometry3d& found, const Isometry3d& truth, const PointCloud& source) {
  const Points a = moved(source, found).points, b = moved(source, truth).points;
  return (a - b).rowwise().norm().mean() / BODY_LENGTH;
}

class EveryMethod : public testing::TestWithParam<RigidMethod> {};
class EveryLocalMethod : public testing::TestWithParam<RigidMethod> {};

TEST_P(EveryLocalMethod, recoversASmallMotion) {
  const PointCloud source = body();
  const Isometry3d truth = turn(source, 0.1, {3, 5, -4});
  const PointCloud target = moved(source, truth);
  ASSERT_GT(miss(Isometry3d::Identity(), truth, source), 0.02);
  const RigidResult result = registerRigidly(GetParam(), source, target);
  EXPECT_EQ(result.failure, "");
  EXPECT_TRUE(result.converged);
  // The cells of NDT are a twentieth of the body, the vertices a fiftieth apart.
  EXPECT_LT(miss(result.T_target_source, truth, source),
            GetParam() == RigidMethod::NDT ? 0.01 : 0.001);
  EXPECT_NEAR(result.T_target_source.linear().determinant(), 1, 1e-9);
}

TEST_P(EveryLocalMethod, worksWithoutNormalsAndWithMissingPoints) {
  PointCloud source = body();
  const Isometry3d truth = turn(source, 0.05, {2, 1, -1});
  PointCloud target = moved(source, truth);
  source.normals.resize(0, 3);
  target.normals.resize(0, 3);
  for (int i = 0; i < source.points.rows(); i += 50)
    source.points.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
  const RigidResult result = registerRigidly(GetParam(), source, target);
  EXPECT_EQ(result.failure, "");
  PointCloud whole = body();
  EXPECT_LT(miss(result.T_target_source, truth, whole), 0.01);
}

TEST_P(EveryLocalMethod, givesTheSameEveryTimeWithAnyNumberOfThreads) {
  const PointCloud source = body();
  const PointCloud target = moved(source, turn(source, 0.3, {10, 0, 5}));
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const RigidResult one = registerRigidly(GetParam(), source, target);
  omp_set_num_threads(3);
  const RigidResult three = registerRigidly(GetParam(), source, target);
  omp_set_num_threads(threads);
  EXPECT_TRUE(one.T_target_source.matrix() == three.T_target_source.matrix());
  EXPECT_EQ(one.converged, three.converged);
}

TEST_P(EveryLocalMethod, isNotPulledByPartsThatOnlyOneSideHas) {
  BodyOptions options;
  options.vertices = 1500;
  const RigidPair pair = makeRigidPair(options);
  PointCloud source, target;
  source.points = pair.source.mesh.vertices;
  target.points = pair.target.mesh.vertices;
  const RigidResult result = registerRigidly(GetParam(), source, target);
  EXPECT_TRUE(result.converged);
  const auto missOf = [&](const Isometry3d& motion) {
    return (moved(source, motion).points - moved(source, pair.T_target_source).points)
        .rowwise()
        .norm()
        .mean();
  };
  EXPECT_GT(missOf(Isometry3d::Identity()), 0.04);  // the body is about 1 long
  EXPECT_LT(missOf(result.T_target_source), 0.01);
}

TEST_P(EveryMethod, endsWithoutAnAlignmentWhereThereIsNone) {
  PointCloud line, point;
  line.points = Points::Zero(40, 3);
  for (int i = 0; i < 40; ++i) line.points(i, 0) = i;
  const RigidResult result = registerRigidly(GetParam(), line, body());
  EXPECT_TRUE(result.T_target_source.matrix().allFinite());  // whatever it is, it is a motion
  point.points = Points::Ones(20, 3);
  const auto with = [&](const PointCloud& source, const PointCloud& target) {
    return test::inputErrorOf([&] { registerRigidly(GetParam(), source, target); });
  };
  EXPECT_EQ(with(body(), point), "all points at one place");
  PointCloud few;
  few.points = Points::Random(12, 3);
  few.points.topRows(5).setConstant(std::nan(""));
  EXPECT_EQ(with(few, body()), "7 points, expected 10 or more");
  EXPECT_EQ(with(body(), few), "7 points, expected 10 or more");
}

TEST_P(EveryMethod, refusesWhatItCannotComputeWith) {
  const auto with = [&](const PointCloud& source, const PointCloud& target) {
    return test::inputErrorOf([&] { registerRigidly(GetParam(), source, target); });
  };
  for (const double unit : {1e160, 1e300}) {
    PointCloud large = body(), small = body();
    large.points *= unit;
    small.points /= unit;
    EXPECT_EQ(with(body(), large), "has coordinates too large to compute with");
    EXPECT_EQ(with(body(), small), "is too small to compute with");
    EXPECT_EQ(with(large, body()), "a point too far off to compute with");
  }
}

/// The step has no single solution there, and PCL's search ends the program at no number.
TEST_P(EveryMethod, endsOnAPlane) {
  Rng rng(5);
  PointCloud plane;
  plane.points = Points::Zero(600, 3);
  for (int i = 0; i < 600; ++i) plane.points.row(i) << rng.uniform(), rng.uniform(), 0;
  const RigidResult result = registerRigidly(GetParam(), plane, plane);
  EXPECT_TRUE(result.T_target_source.matrix().allFinite());
  if (GetParam() == RigidMethod::ICP) {  // it asks for no normals: the plane lies on itself
    EXPECT_TRUE(result.converged);
    EXPECT_TRUE(result.T_target_source.matrix().isIdentity(1e-6));
  }
  if (GetParam() == RigidMethod::ICP_POINT_TO_PLANE) {
    EXPECT_FALSE(result.converged);
    EXPECT_TRUE(result.T_target_source.matrix().isIdentity());
  }
}

TEST_P(EveryMethod, leavesPclAsTalkativeAsItWas) {
  const auto before = pcl::console::getVerbosityLevel();
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  PointCloud far = body();
  far.points *= 1000;  // no correspondences near enough: something to complain of
  registerRigidly(GetParam(), far, body());
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(pcl::console::getVerbosityLevel(), before);
}

std::string testName(const testing::TestParamInfo<RigidMethod>& method) {
  std::string name = keyOf(method.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(RigidRegistration,
                         EveryLocalMethod,
                         testing::Values(RigidMethod::ICP,
                                         RigidMethod::ICP_POINT_TO_PLANE,
                                         RigidMethod::GICP,
                                         RigidMethod::NDT),
                         testName);
INSTANTIATE_TEST_SUITE_P(RigidRegistration,
                         EveryMethod,
                         testing::ValuesIn(rigidMethods()),
                         testName);

TEST(RigidRegistration, featuresNeedNoStart) {
  const PointCloud source = body();
  const Isometry3d truth = turn(source, 2.4, {700, -300, 900});
  const PointCloud target = moved(makeCloud(1), truth);  // its vertices lie elsewhere
  const RigidResult global = registerRigidly(RigidMethod::FPFH_ICP, source, target);
  EXPECT_TRUE(global.converged);
  EXPECT_LT(miss(global.T_target_source, truth, source), 0.005);
  // The others only look around: the same pair is out of their reach.
  const RigidResult local = registerRigidly(RigidMethod::ICP, source, target);
  EXPECT_GT(miss(local.T_target_source, truth, source), 0.1);
}

TEST(RigidRegistration, featuresGiveTheSameEveryTime) {
  const PointCloud other = makeCloud(0, 1);  // bent: few samples fit, which is quick
  const int threads = omp_get_max_threads();
  const RigidResult first = registerRigidly(RigidMethod::FPFH_ICP, body(), other);
  std::rand();
  omp_set_num_threads(1);
  const RigidResult second = registerRigidly(RigidMethod::FPFH_ICP, body(), other);
  omp_set_num_threads(threads);
  EXPECT_FALSE(first.T_target_source.matrix().isIdentity(1e-3));
  EXPECT_TRUE(first.T_target_source.matrix() == second.T_target_source.matrix());
}

}  // namespace
}  // namespace posture
