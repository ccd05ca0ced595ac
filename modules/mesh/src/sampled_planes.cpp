// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sampled_planes.h"

#include <posture/core/rng.h>
#include <posture/mesh/areas.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace posture {
namespace {

constexpr int SEEDS = 256;

/// How far around a seed a plane is begun with, and how far from it such a plane may be.
constexpr double SEED_RADIUS = 0.06, SEED_REACH = 0.005;

/// How thick a scanner makes a plane, at least and at most.
constexpr double LEAST_REACH = 0.002, MOST_REACH = 0.015;

/// Of what is within the most, what is within half of it: of a part of a body that is nearly flat
/// hardly more than half.
constexpr double LEAST_DENSE = 0.85;

/// Of the area: smaller planes are parts of bodies, or hardly matter.
constexpr double LEAST_PLANE = 0.05;

/// Cosine: faces in a plane look that much along its normal.
constexpr double ALONG_NORMAL = 0.7;

/// The plane that fits some samples best, and how far they are from it (root of the mean square).
std::pair<Plane, double> fitPlane(const AreaSamples& samples, const std::vector<int>& some) {
  const Points points = samples.points(some, Eigen::all);
  const Eigen::RowVector3d mean = points.colwise().mean();
  const Points about = points.rowwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moments(about.transpose() * about);
  Plane plane;
  plane.reach = SEED_REACH;
  plane.normal = moments.eigenvectors().col(0).transpose();
  plane.offset = mean.dot(plane.normal);
  const double sum = std::max(0.0, moments.eigenvalues()[0]);
  return {plane, std::sqrt(sum / static_cast<double>(some.size()))};
}

std::vector<int> heldBy(const Plane& plane,
                        const AreaSamples& samples,
                        const std::vector<int>& among) {
  std::vector<int> held;
  std::copy_if(among.begin(), among.end(), std::back_inserter(held), [&](int i) {
    return plane.holds(samples, i);
  });
  return held;
}

/// The plane through a sample and what is near it, if that is flat.
std::optional<Plane> planeAround(int seed,
                                 const AreaSamples& samples,
                                 const std::vector<int>& among) {
  std::vector<int> near;
  const Eigen::RowVector3d center = samples.points.row(seed);
  std::copy_if(among.begin(), among.end(), std::back_inserter(near), [&](int i) {
    return (samples.points.row(i) - center).squaredNorm() < SEED_RADIUS * SEED_RADIUS;
  });
  constexpr std::size_t ENOUGH = 8;
  if (near.size() < ENOUGH) return std::nullopt;
  const auto [plane, scatter] = fitPlane(samples, near);
  return scatter < SEED_REACH ? std::optional(plane) : std::nullopt;
}

/// How far what is in a plane lies from it; none: it is no plane, or holds few of some samples.
std::optional<double> reachOf(Plane plane,
                              const AreaSamples& samples,
                              const std::vector<int>& among) {
  plane.reach = MOST_REACH;
  std::vector<double> distances;
  for (int i : heldBy(plane, samples, among))
    distances.push_back(std::abs(plane.height(samples.points.row(i))));
  std::sort(distances.begin(), distances.end());
  const auto n = static_cast<double>(distances.size());
  const auto near =
      std::upper_bound(distances.begin(), distances.end(), 0.5 * MOST_REACH) - distances.begin();
  if (n < LEAST_PLANE * AreaSamples::MOST || static_cast<double>(near) < LEAST_DENSE * n)
    return std::nullopt;
  // Twice what 95 in 100 lie within is four deviations, three of vertices, which scatter more.
  const double most = distances[static_cast<std::size_t>(0.95 * n)];
  return std::clamp(2 * most, LEAST_REACH, MOST_REACH);
}

}  // namespace

AreaSamples::AreaSamples(const TriangleMesh& mesh)
    : points(Points::Zero(MOST, 3)), normals(Points::Zero(MOST, 3)) {
  const Vector areas = faceAreas(mesh);
  const double total = areas.sum(), unit = 1 / std::sqrt(total);
  Rng rng(1);
  double before = 0;
  int sample = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const double after = before + areas[f];
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(f, 0)),
                             ab = mesh.vertices.row(mesh.faces(f, 1)) - a,
                             ac = mesh.vertices.row(mesh.faces(f, 2)) - a;
    const Eigen::RowVector3d normal = ab.cross(ac).normalized();
    for (; sample < MOST && (sample + 0.5) * total < after * MOST; ++sample) {
      double u = rng.uniform(), v = rng.uniform();
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      points.row(sample) = unit * (a + u * ab + v * ac);
      normals.row(sample) = normal;
    }
    before = after;
  }
  points.conservativeResize(sample, 3);
  normals.conservativeResize(sample, 3);
}

bool Plane::holds(const AreaSamples& samples, int i) const {
  return std::abs(height(samples.points.row(i))) <= reach &&
         std::abs(samples.normals.row(i).dot(normal)) > ALONG_NORMAL;
}

std::optional<Plane> largestPlane(const AreaSamples& samples, const std::vector<int>& among) {
  std::optional<Plane> best;
  std::size_t most = 0;
  const std::size_t step = std::max<std::size_t>(1, among.size() / SEEDS);
  for (std::size_t k = 0; k < among.size(); k += step) {
    const std::optional<Plane> plane = planeAround(among[k], samples, among);
    if (!plane) continue;
    const std::size_t held = heldBy(*plane, samples, among).size();
    if (held <= most) continue;
    most = held;
    best = plane;
  }
  constexpr int ROUNDS = 3;
  for (int round = 0; round < ROUNDS; ++round) {
    const std::vector<int> held = best ? heldBy(*best, samples, among) : std::vector<int>();
    if (held.size() < LEAST_PLANE * AreaSamples::MOST) return std::nullopt;
    best = fitPlane(samples, held).first;
  }
  const std::optional<double> reach = reachOf(*best, samples, among);
  if (!reach) return std::nullopt;
  best->reach = *reach;
  return best;
}

}  // namespace posture
