// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcl/poisson_plugin.h"

#include <pcl/pcl_base.h>
#include <pcl/surface/reconstruction.h>

#include "pcl/pcl_cloud.h"
#include <cstdio>
#include <iostream>
#include <omp.h>
#include <unordered_map>

// PCL's octree reports oddities on stdout, which belongs to the caller: it is compiled here
// instead, in silence.
#define PCL_NO_PRECOMPILE
#define printf(...) static_cast<void>(0)
#include <pcl/surface/poisson.h>
#undef printf

extern "C" __attribute__((visibility("default"))) void posturePoissonSurface(
    const posture::OrientedPoints& oriented, int depth, posture::TriangleMesh& mesh) {
  pcl::Poisson<pcl::PointNormal> poisson;
  poisson.setDepth(depth);
  // More threads sum in another order.
  poisson.setThreads(1);
  poisson.setInputCloud(posture::toPclCloud(oriented));
  pcl::PointCloud<pcl::PointNormal> vertices;
  std::vector<pcl::Vertices> polygons;
  poisson.performReconstruction(vertices, polygons);
  mesh = {posture::Points(static_cast<Eigen::Index>(vertices.size()), 3),
          posture::toFaces(polygons)};
  for (std::size_t v = 0; v < vertices.size(); ++v)
    mesh.vertices.row(static_cast<Eigen::Index>(v)) =
        vertices[v].getVector3fMap().transpose().cast<double>();
}
