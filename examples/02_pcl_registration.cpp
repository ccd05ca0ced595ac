// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A program written for pcl::IterativeClosestPoint, and what changes for bodies that bend: the
// type.
//   02_pcl_registration SOURCE TARGET TRUTH
// The shapes' points are used, without faces. TRUTH has a row `source_point target_point` for each
// known pair.
#include <posture/core/error.h>
#include <posture/evaluation/truth.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/shape_io.h>
#include <posture/registration/isometric_registration.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>

#include <cstdio>
#include <vector>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Rigid = pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ>;
using Bending = posture::IsometricRegistration<pcl::PointXYZ, pcl::PointXYZ>;

// The program: nothing in it is about one of the two.
template <class Registration>
Cloud registered(const char* name, const Cloud::Ptr& source, const Cloud::Ptr& target) {
  Registration registration;
  registration.setInputSource(source);
  registration.setInputTarget(target);
  Cloud output;
  registration.align(output);
  std::printf("%-24s converged: %-3s  fitness: %.6f",
              name,
              registration.hasConverged() ? "yes" : "no",
              registration.getFitnessScore());
  return output;
}

// Mean distance of points from their true places, in percent of the target's largest extent.
double printError(const Cloud& output,
                  const Cloud& target,
                  const std::vector<posture::VertexPair>& truth) {
  double sum = 0;
  for (const posture::VertexPair& pair : truth)
    sum += (output[pair.source].getVector3fMap() - target[pair.target].getVector3fMap()).norm();
  const auto places = target.getMatrixXfMap(3, 4, 0);
  const double extent = (places.rowwise().maxCoeff() - places.rowwise().minCoeff()).maxCoeff();
  const double percent = 100 * sum / static_cast<double>(truth.size()) / extent;
  std::printf("  mean error: %.2f %%\n", percent);
  return percent;
}

Cloud::Ptr read(const char* path) {
  const posture::Points points = posture::readShape(path).cloud.points;
  auto cloud = pcl::make_shared<Cloud>();
  for (int i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3f p = points.row(i).cast<float>();
    cloud->push_back({p.x(), p.y(), p.z()});
  }
  return cloud;
}

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s SOURCE TARGET TRUTH\n", argv[0]);
    return 2;
  }
  try {
    const Cloud::Ptr source = read(argv[1]), target = read(argv[2]);
    const std::vector<posture::VertexPair> truth = posture::readTruth(
        argv[3], static_cast<int>(source->size()), static_cast<int>(target->size()));
    const double rigid =
        printError(registered<Rigid>("IterativeClosestPoint", source, target), *target, truth);
    const double bending =
        printError(registered<Bending>("IsometricRegistration", source, target), *target, truth);
    return bending < 3 && bending < rigid ? 0 : 1;
  } catch (const posture::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
