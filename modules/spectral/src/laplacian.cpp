// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/spectral/laplacian.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace posture {
namespace {

/// Faces thinner than a hundredth of their length count as that: a needle must not outweigh a
/// surface.
constexpr double STEEPEST_COTANGENT = 100;

}  // namespace

Laplacian cotangentLaplacian(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  Laplacian laplacian;
  laplacian.mass = Vector::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(n + 12 * static_cast<std::size_t>(mesh.faces.rows()));
  // A vertex in no face has its diagonal entry too.
  for (int v = 0; v < n; ++v) entries.emplace_back(v, v, 0.0);
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    double longest_sq = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = mesh.faces(f, k), j = mesh.faces(f, (k + 1) % 3);
      longest_sq =
          std::max(longest_sq, (mesh.vertices.row(i) - mesh.vertices.row(j)).squaredNorm());
    }
    // The same for all three corners: weights that shrink alike stay positive semi-definite.
    const double least = longest_sq / STEEPEST_COTANGENT;
    for (int k = 0; k < 3; ++k) {
      const int at = mesh.faces(f, k), i = mesh.faces(f, (k + 1) % 3),
                j = mesh.faces(f, (k + 2) % 3);
      const Eigen::Vector3d u = mesh.vertices.row(i) - mesh.vertices.row(at);
      const Eigen::Vector3d v = mesh.vertices.row(j) - mesh.vertices.row(at);
      const double twice_area = u.cross(v).norm();
      laplacian.mass[at] += twice_area / 6;
      if (!(least > 0)) continue;
      const double weight = 0.5 * u.dot(v) / std::max(twice_area, least);
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
    }
  }
  laplacian.stiffness.resize(n, n);
  laplacian.stiffness.setFromTriplets(entries.begin(), entries.end());
  // A vertex of faces without area still needs a weight to divide by.
  const double least_mass = 1e-6 * laplacian.mass.mean();
  laplacian.mass = laplacian.mass.cwiseMax(least_mass);
  return laplacian;
}

}  // namespace posture
