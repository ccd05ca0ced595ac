// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/silent_pcl.h>

#include <pcl/search/kdtree.h>

#include "pcl/pcl_cloud.h"
#include "pcl/pcl_surfaces.h"
// The templates themselves: libpcl_surface, which has them compiled, links VTK.
#include <pcl/surface/gp3.h>
#include <pcl/surface/impl/gp3.hpp>

#include <cmath>

namespace posture {

TriangleMesh greedySurface(const OrientedPoints& oriented, double spacing) {
  const SilentPcl silent;
  pcl::GreedyProjectionTriangulation<pcl::PointNormal> greedy;
  // The factors are those of PCL's tutorial, but for the radius, which is three spacings.
  greedy.setSearchRadius(3 * spacing);
  greedy.setMu(2.5);
  greedy.setMaximumNearestNeighbors(100);
  greedy.setMaximumSurfaceAngle(M_PI / 4);
  greedy.setMinimumAngle(M_PI / 18);
  greedy.setMaximumAngle(2 * M_PI / 3);
  greedy.setNormalConsistency(true);
  greedy.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
  greedy.setInputCloud(toPclCloud(oriented));
  std::vector<pcl::Vertices> polygons;
  greedy.reconstruct(polygons);
  return {oriented.points, toFaces(polygons)};
}

}  // namespace posture
