// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/core/rng.h>
#include <posture/synthesis/depth_camera.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace posture {
namespace {

constexpr double NOTHING = std::numeric_limits<double>::quiet_NaN();

class DepthSensor {
 public:
  DepthSensor(const RayCaster& scene,
              const TriangleMesh& mesh,
              const DepthCamera& camera,
              const DepthDefects& defects,
              std::uint64_t seed)
      : scene_(scene), mesh_(mesh), camera_(camera), defects_(defects), rng_(seed) {}

  DepthImage take() {
    look();
    DepthImage image;
    const auto pixels = static_cast<Eigen::Index>(seen_.size());
    image.depth = Vector::Constant(pixels, NOTHING);
    image.hit.resize(seen_.size());
    for (int row = 0; row < camera_.height; ++row)
      for (int column = 0; column < camera_.width; ++column) measure(column, row, image);
    return image;
  }

 private:
  /// The rays, without what the sensor makes of them. A ray has z = 1: its distance is its depth.
  void look() {
    const std::size_t pixels = static_cast<std::size_t>(camera_.width) * camera_.height;
    std::vector<Eigen::Vector2d> aside(pixels);
    for (Eigen::Vector2d& offset : aside) {
      const double x = rng_.normal(), y = rng_.normal();
      offset = defects_.jitter * Eigen::Vector2d(x, y);
    }
    seen_.resize(pixels);
    const Eigen::Isometry3d& pose = camera_.T_world_camera;
    parallelFor(camera_.height, [&](int row) {
      for (int column = 0; column < camera_.width; ++column) {
        const std::size_t pixel = place(column, row);
        const Eigen::Vector3d ray = camera_.ray(column + aside[pixel].x(), row + aside[pixel].y());
        seen_[pixel] = scene_.cast(pose.translation(), pose.linear() * ray);
      }
    });
    farthest_ = nearest_ = NOTHING;
    for (const RayHit& hit : seen_) {
      if (hit.face < 0) continue;
      nearest_ = std::fmin(nearest_, hit.distance);
      farthest_ = std::fmax(farthest_, hit.distance);
    }
  }

  std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.width) +
           static_cast<std::size_t>(column);
  }

  void measure(int column, int row, DepthImage& image) {
    const std::size_t pixel = place(column, row);
    const RayHit& hit = seen_[pixel];
    // Every pixel takes as many random numbers, whatever becomes of it.
    const double noise = rng_.normal(), loss = rng_.uniform(), flight = rng_.uniform(),
                 way = rng_.uniform(), outlier = rng_.uniform(), anywhere = rng_.uniform();
    double& depth = image.depth[static_cast<Eigen::Index>(pixel)];
    if (outlier < defects_.outliers * (hit.face >= 0 ? 1 : EMPTY_SHARE)) {
      const double span = farthest_ - nearest_;
      depth = quantised(nearest_ - 0.1 * span + 1.2 * span * anywhere);
      return;
    }
    if (hit.face < 0) return;
    const double cosine = incidence(hit, column, row);
    if (cosine < defects_.lost_aslant * (1 + loss)) return;
    const double behind = gapBehind(column, row);
    if (behind > 0 && flight < defects_.flying) {
      depth = quantised(hit.distance + way * behind);
      return;
    }
    const double relative = hit.distance / defects_.reference_depth;
    // tan of the incidence: how much depth a pixel spans.
    const double aslant = std::sqrt(std::max(0.0, 1 - cosine * cosine)) / std::max(cosine, 0.1);
    const double deviation = defects_.noise * relative * relative * (1 + ASLANT_NOISE * aslant);
    depth = quantised(hit.distance + deviation * noise);
    image.hit[pixel] = hit;
  }

  double incidence(const RayHit& hit, int column, int row) const {
    const Eigen::RowVector3d a = mesh_.vertices.row(mesh_.faces(hit.face, 0)),
                             b = mesh_.vertices.row(mesh_.faces(hit.face, 1)),
                             c = mesh_.vertices.row(mesh_.faces(hit.face, 2));
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized().transpose();
    const Eigen::Vector3d ray =
        camera_.T_world_camera.linear() * camera_.ray(column, row).normalized();
    return std::abs(normal.dot(ray));
  }

  /// How far behind this pixel's depth a neighbour's is, if it is a silhouette's; where nothing is
  /// behind, twice the depth that makes one.
  double gapBehind(int column, int row) const {
    const double here = seen_[place(column, row)].distance;
    double gap = 0;
    for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
      const int x = column + dx, y = row + dy;
      if (x < 0 || y < 0 || x >= camera_.width || y >= camera_.height) continue;
      const RayHit& neighbor = seen_[place(x, y)];
      const double behind = neighbor.face < 0 ? 2 * defects_.depth_edge : neighbor.distance - here;
      if (behind > defects_.depth_edge) gap = std::max(gap, behind);
    }
    return gap;
  }

  /// Disparity, which goes with 1 / depth, is what has equal steps.
  double quantised(double depth) const {
    if (defects_.step <= 0) return depth;
    const double reference = defects_.reference_depth;
    const double steps = std::round(reference * reference / (defects_.step * depth));
    return reference * reference / (defects_.step * std::max(steps, 1.0));
  }

  static constexpr double ASLANT_NOISE = 0.5;  // at 45 degrees half as much again
  static constexpr double EMPTY_SHARE = 0.1;   // fewer returns where there is nothing to see

  const RayCaster& scene_;
  const TriangleMesh& mesh_;
  const DepthCamera& camera_;
  const DepthDefects& defects_;
  Rng rng_;
  std::vector<RayHit> seen_;
  double nearest_ = NOTHING, farthest_ = NOTHING;
};

}  // namespace

DepthImage takeDepthImage(const RayCaster& scene,
                          const TriangleMesh& mesh,
                          const DepthCamera& camera,
                          const DepthDefects& defects,
                          std::uint64_t seed) {
  return DepthSensor(scene, mesh, camera, defects, seed).take();
}

}  // namespace posture
