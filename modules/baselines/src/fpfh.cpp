// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/fpfh.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/registration/sample_consensus_prerejective.h>

#include "finite_search.h"
#include "local_methods.h"
#include "normals.h"
#include "pcl_cloud.h"
#include <algorithm>
#include <cstdlib>

namespace posture {
namespace {

// In the tutorial's proportions.
constexpr auto LEAF = static_cast<float>(FEATURE_LEAF);
constexpr float NORMAL_RADIUS = LEAF;
constexpr float FEATURE_RADIUS = 5 * LEAF;
constexpr float INLIER_DISTANCE = 2.5f * LEAF;

using Cloud = pcl::PointCloud<pcl::PointNormal>;
using Features = pcl::PointCloud<pcl::FPFHSignature33>;

template <class Point>
typename pcl::PointCloud<Point>::Ptr filtered(const typename pcl::PointCloud<Point>::Ptr& cloud) {
  auto result = pcl::make_shared<pcl::PointCloud<Point>>();
  pcl::VoxelGrid<Point> grid;
  grid.setLeafSize(LEAF, LEAF, LEAF);
  grid.setInputCloud(cloud);
  grid.filter(*result);
  return result;
}

/// PCL takes the fit of each sample at random from so many nearest features and asks for no fewer.
constexpr int NEAREST_FEATURES = 5;

/// Filtered: normals that are given are averaged, others estimated for what is left, from all
/// points.
Cloud::Ptr prepared(const LocalCloud& local) {
  if (local.normals.rows() > 0) {
    Cloud::Ptr cloud = filtered<pcl::PointNormal>(toPclWithNormals(local));
    for (pcl::PointNormal& point : *cloud) point.getNormalVector3fMap().normalize();
    return cloud;
  }
  const auto cloud = filtered<pcl::PointXYZ>(toPcl(local.points));
  LocalCloud reduced{Points(static_cast<Eigen::Index>(cloud->size()), 3), {}, local.sensor};
  for (int i = 0; i < reduced.points.rows(); ++i)
    reduced.points.row(i) = (*cloud)[i].getVector3fMap().transpose().cast<double>();
  return toPclWithNormals(withNormals(reduced, local.points, NORMAL_RADIUS));
}

struct Described {
  Cloud::Ptr points;
  Features::Ptr features;
};

/// Points whose surroundings are too empty to describe are left out.
Described describe(const Cloud::Ptr& cloud) {
  Features all;
  pcl::FPFHEstimation<pcl::PointNormal, pcl::PointNormal, pcl::FPFHSignature33> estimation;
  estimation.setRadiusSearch(FEATURE_RADIUS);
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  estimation.compute(all);
  Described result{pcl::make_shared<Cloud>(), pcl::make_shared<Features>()};
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const float* const histogram = all[i].histogram;
    if (!std::all_of(histogram, histogram + 33, [](float h) { return std::isfinite(h); })) continue;
    result.points->push_back((*cloud)[i]);
    result.features->push_back(all[i]);
  }
  return result;
}

}  // namespace

Alignment alignFeatures(const LocalCloud& source, const LocalCloud& target, std::uint64_t seed) {
  const Described from = describe(prepared(source)), to = describe(prepared(target));
  if (from.points->size() < NEAREST_FEATURES || to.points->size() < NEAREST_FEATURES) return {};
  std::srand(static_cast<unsigned>(seed));
  pcl::SampleConsensusPrerejective<pcl::PointNormal, pcl::PointNormal, pcl::FPFHSignature33>
      registration;
  registration.setInputSource(from.points);
  registration.setSourceFeatures(from.features);
  registration.setInputTarget(to.points);
  registration.setTargetFeatures(to.features);
  registration.setSearchMethodTarget(pcl::make_shared<FiniteSearch<pcl::PointNormal>>());
  registration.setMaximumIterations(50000);
  registration.setNumberOfSamples(3);
  registration.setCorrespondenceRandomness(NEAREST_FEATURES);
  registration.setSimilarityThreshold(0.95f);
  registration.setMaxCorrespondenceDistance(INLIER_DISTANCE);
  registration.setInlierFraction(0.25f);
  Cloud moved;
  registration.align(moved);
  if (!registration.hasConverged()) return {};
  return {registration.getFinalTransformation().cast<double>(), true};
}

}  // namespace posture
