// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/point_index.h>

#include "pcl/pcl_surfaces.h"
#include "pcl/poisson_plugin.h"
#include "points/in_line.h"
#include <algorithm>
#include <cmath>
#include <dlfcn.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace posture {
namespace {

PoissonFunction loadPoisson() {
  if (void* library = dlopen(POISSON_LIBRARY, RTLD_NOW | RTLD_LOCAL))
    if (void* function = dlsym(library, POISSON_FUNCTION))
      return reinterpret_cast<PoissonFunction>(function);
  throw std::runtime_error(std::string("the Poisson surface is not installed: ") + dlerror());
}

}  // namespace

TriangleMesh poissonSurface(const OrientedPoints& oriented,
                            const NeighborTable& neighbors,
                            double spacing) {
  static const PoissonFunction POISSON = loadPoisson();
  const double extent =
      (oriented.points.colwise().maxCoeff() - oriented.points.colwise().minCoeff()).maxCoeff();
  // Cells of the octree as wide as the points are apart; PCL's box is a tenth wider than they. Few
  // points in a large box are of several scales: a surface of n cells is about sqrt(n) across.
  const double across = std::sqrt(static_cast<double>(oriented.points.rows()));
  const int finest = std::clamp(static_cast<int>(std::ceil(std::log2(across))) + 3, 5, 12);
  const int depth =
      std::clamp(static_cast<int>(std::ceil(std::log2(1.1 * extent / spacing))), 5, finest);
  TriangleMesh mesh;
  POISSON(oriented, depth, mesh);

  std::vector<char> in_line(oriented.points.rows());
  for (int i = 0; i < oriented.points.rows(); ++i)
    in_line[i] = isInLine(oriented.points, neighbors, i);
  const PointIndex index(oriented.points);
  const Points normals = vertexNormals(mesh);
  const int n = static_cast<int>(mesh.vertices.rows());
  std::vector<char> supported(n);
  forEach(n, [&](int v) {
    const auto near = index.nearest(mesh.vertices.row(v));
    // Of either sign: which way PCL turns its faces is the caller's business.
    supported[v] = near.distance <= 2 * spacing && !in_line[near.index] &&
                   std::abs(normals.row(v).dot(oriented.normals.row(near.index))) > 0.2;
  });
  std::vector<int> kept;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    if (supported[mesh.faces(f, 0)] && supported[mesh.faces(f, 1)] && supported[mesh.faces(f, 2)])
      kept.push_back(f);
  mesh.faces = Faces(mesh.faces(kept, Eigen::all));
  return mesh;
}

}  // namespace posture
