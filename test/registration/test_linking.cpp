// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/registration/isometric_correspondence_estimation.h>
#include <posture/registration/isometric_registration.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

namespace posture {
namespace {

/// File names of the shared libraries in this process.
std::set<std::string> loadedLibraries() {
  std::set<std::string> names;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const std::string name = line.substr(line.rfind('/') + 1);
    if (name.find(".so") != std::string::npos) names.insert(name);
  }
  return names;
}

TEST(Linking, bringsNeitherVtkNorQt) {
  using testing::AnyOf;
  using testing::Contains;
  using testing::Each;
  using testing::Not;
  using testing::StartsWith;
  // Used, so that they are linked.
  IsometricRegistration<pcl::PointXYZ, pcl::PointXYZ> registration;
  IsometricCorrespondenceEstimation<pcl::PointXYZ, pcl::PointXYZ> estimation;
  EXPECT_FALSE(registration.hasConverged());
  const std::set<std::string> libraries = loadedLibraries();
  EXPECT_THAT(libraries, Contains(StartsWith("libpcl_common")));
  EXPECT_THAT(libraries, Each(Not(AnyOf(StartsWith("libvtk"), StartsWith("libQt")))));
}

}  // namespace
}  // namespace posture
