// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/matrix_of.h>
#include <posture/core/rng.h>
#include <posture/synthesis/depth_camera.h>
#include <posture/synthesis/simulated_scan.h>

#include "nearest_places.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace posture {

using namespace synthesis;

namespace {

constexpr double NOTHING = std::numeric_limits<double>::quiet_NaN();

/// From the middle of the body in radii of the sphere around it: it fills an image 47 degrees high.
constexpr double CAMERA_DISTANCE = 2.5;
/// Of the returns that the geometry allows, about so many survive the sensor.
constexpr double KEPT_SHARE = 0.95;
/// How far a place may be from the next point, in spacings: surfaces are seen aslant.
constexpr double REACH = 1.5;

void check(const ArticulatedBody& body, const ScanOptions& options) {
  require(options.views >= 1, "views " + std::to_string(options.views) + ", expected 1 or more");
  require(options.points >= 100,
          "points " + std::to_string(options.points) + ", expected 100 or more");
  require(std::isfinite(options.noise) && options.noise >= 0,
          "noise " + std::to_string(options.noise) + ", expected 0 or more");
  require(body.mesh.faces.rows() > 0, "a body without faces");
}

Eigen::Quaterniond randomRotation(Rng& rng) {
  const double w = rng.normal(), x = rng.normal(), y = rng.normal(), z = rng.normal();
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

Eigen::Vector3d randomVector(Rng& rng, double deviation) {
  const double x = rng.normal(), y = rng.normal(), z = rng.normal();
  return deviation * Eigen::Vector3d(x, y, z);
}

/// As if the body were 1.7 m: in metres, centimetres, millimetres or inches.
double randomUnit(Rng& rng) {
  constexpr double PER_METRE[] = {1, 100, 1000, 1 / 0.0254};
  return 1.7 * PER_METRE[rng.below(4)];
}

struct Sphere {
  Eigen::Vector3d center;
  double radius = 0;
};

Sphere sphereAround(const Points& points) {
  Sphere sphere;
  sphere.center = 0.5 * (points.colwise().minCoeff() + points.colwise().maxCoeff()).transpose();
  sphere.radius = (points.rowwise() - sphere.center.transpose()).rowwise().norm().maxCoeff();
  return sphere;
}

/// From where the body in the rest pose is broadest: a person from the front, an animal from the
/// side.
double broadSide(const Points& rest_position) {
  const Eigen::RowVector3d size =
      rest_position.colwise().maxCoeff() - rest_position.colwise().minCoeff();
  return size.x() > size.y() ? M_PI / 2 : 0;
}

/// Cameras all around, in turn from above and from a little below.
std::vector<Eigen::Isometry3d> placeCameras(const ArticulatedBody& body,
                                            const Sphere& sphere,
                                            int views,
                                            Rng& rng) {
  constexpr double ABOVE = 35 * M_PI / 180, BELOW = -12 * M_PI / 180, ALONE = 10 * M_PI / 180;
  constexpr double SCATTER = 10 * M_PI / 180;
  const double start = views == 1 ? broadSide(body.rest_position) : 2 * M_PI * rng.uniform();
  std::vector<Eigen::Isometry3d> cameras;
  for (int i = 0; i < views; ++i) {
    const double azimuth = start + 2 * M_PI * i / views + SCATTER * (2 * rng.uniform() - 1);
    const double elevation = (views == 1   ? ALONE
                              : i % 2 == 0 ? ABOVE
                                           : BELOW) +
                             0.5 * SCATTER * (2 * rng.uniform() - 1);
    const Eigen::Vector3d outwards(std::cos(elevation) * std::cos(azimuth),
                                   std::cos(elevation) * std::sin(azimuth),
                                   std::sin(elevation));
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = sphere.center + CAMERA_DISTANCE * sphere.radius * outwards;
    const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(outwards).normalized();
    pose.linear() << right, right.cross(outwards), -outwards;
    cameras.push_back(pose);
  }
  return cameras;
}

/// Square, the sphere just inside.
DepthCamera cameraOf(const Eigen::Isometry3d& T_world_camera, double focal) {
  DepthCamera camera;
  camera.T_world_camera = T_world_camera;
  camera.focal = focal;
  camera.width = camera.height =
      static_cast<int>(std::ceil(2 * focal * std::tan(std::asin(1 / CAMERA_DISTANCE))));
  return camera;
}

/// So that the cameras together see about so many points.
double focalFor(int points,
                const RayCaster& scene,
                const TriangleMesh& mesh,
                const std::vector<Eigen::Isometry3d>& cameras) {
  constexpr double TRIAL = 100;
  double returns = 0;
  for (const Eigen::Isometry3d& pose : cameras)
    returns += static_cast<double>(
        takeDepthImage(scene, mesh, cameraOf(pose, TRIAL), {}, 0).depth.array().isFinite().count());
  return TRIAL * std::sqrt(points / (KEPT_SHARE * std::max(returns, 1.0)));
}

/// Of the order of a thousandth of the body with noise 1.
DepthDefects defectsOf(double noise, double distance, double spacing) {
  const double present = std::min(noise, 1.0);
  DepthDefects defects;
  defects.noise = 0.001 * noise;
  defects.step = 0.001 * noise;
  defects.reference_depth = distance;
  defects.jitter = 0.0005 * noise / spacing;
  defects.lost_aslant = 0.12 * present;
  defects.depth_edge = 0.03;
  defects.flying = 0.25 * present;
  defects.outliers = 0.003 * present;
  return defects;
}

class ScanBuilder {
 public:
  ScanBuilder(const ArticulatedBody& body, const ScanOptions& options)
      : body_(body), options_(options), rng_(options.seed), scene_(body.mesh) {}

  SimulatedScan build() {
    const Sphere sphere = sphereAround(body_.mesh.vertices);
    const double distance = CAMERA_DISTANCE * sphere.radius;
    const auto cameras = placeCameras(body_, sphere, options_.views, rng_);
    const double focal = focalFor(options_.points, scene_, body_.mesh, cameras);
    scan_.spacing = distance / focal;
    scan_.unit = randomUnit(rng_);
    const bool alone = options_.views == 1;
    scan_from_world_ = alone ? cameras[0].inverse() : randomFrame(sphere);
    const DepthDefects defects = defectsOf(options_.noise, distance, scan_.spacing);
    for (const Eigen::Isometry3d& pose : cameras) {
      const DepthCamera camera = cameraOf(pose, focal);
      const Eigen::Isometry3d slip = alone ? Eigen::Isometry3d::Identity() : slipOf(sphere.center);
      add(takeDepthImage(scene_, body_.mesh, camera, defects, rng_.next()), camera, slip);
      if (alone) scan_.cloud.width = camera.width;
    }
    if (alone) scan_.cloud.sensor = Eigen::Vector3d::Zero();
    return finish();
  }

 private:
  Eigen::Isometry3d randomFrame(const Sphere& sphere) {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.linear() = randomRotation(rng_).toRotationMatrix();
    motion.translation() = -(motion.linear() * sphere.center) + randomVector(rng_, 2);
    return motion;
  }

  /// What registering a view left over: it lies a little beside its place.
  Eigen::Isometry3d slipOf(const Eigen::Vector3d& center) {
    constexpr double SHIFT = 0.0004, TURN = 0.0006;
    const Eigen::Vector3d turn = randomVector(rng_, TURN * options_.noise);
    const Eigen::Vector3d shift = randomVector(rng_, SHIFT * options_.noise);
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    if (turn.norm() > 0)
      motion.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).matrix();
    motion.translation() = center + shift - motion.linear() * center;
    return motion;
  }

  Eigen::RowVector3d toScan(const Eigen::Vector3d& point) const {
    return scan_.unit * (scan_from_world_ * point).transpose();
  }

  /// A single image is kept as a grid, of several only the returns.
  void add(const DepthImage& image, const DepthCamera& camera, const Eigen::Isometry3d& slip) {
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column) {
        const Eigen::Index pixel = Eigen::Index{row} * camera.width + column;
        const double depth = image.depth[pixel];
        if (!std::isfinite(depth) && options_.views > 1) continue;
        points_.push_back(toScan(slip * camera.T_world_camera * (depth * camera.ray(column, row))));
        addPlace(image.hit[static_cast<std::size_t>(pixel)]);
      }
  }

  void addPlace(const RayHit& hit) {
    if (hit.face < 0) {
      places_.emplace_back(Eigen::RowVector3d::Constant(NOTHING));
      scan_.vertex.push_back(-1);
      return;
    }
    Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
    for (int corner = 0; corner < 3; ++corner)
      place +=
          hit.barycentric[corner] * body_.rest_position.row(body_.mesh.faces(hit.face, corner));
    int nearest = 0;
    hit.barycentric.maxCoeff(&nearest);
    places_.push_back(place);
    scan_.vertex.push_back(body_.mesh.faces(hit.face, nearest));
  }

  SimulatedScan finish() {
    scan_.cloud.points = matrixOf<Points>(points_);
    scan_.rest_position = matrixOf<Points>(places_);
    scan_.surface = body_.mesh;
    for (Eigen::Index v = 0; v < scan_.surface.vertices.rows(); ++v)
      scan_.surface.vertices.row(v) = toScan(body_.mesh.vertices.row(v).transpose());
    return std::move(scan_);
  }

  const ArticulatedBody& body_;
  const ScanOptions& options_;
  Rng rng_;
  RayCaster scene_;
  Eigen::Isometry3d scan_from_world_ = Eigen::Isometry3d::Identity();
  SimulatedScan scan_;
  std::vector<Eigen::RowVector3d> points_, places_;
};

}  // namespace

SimulatedScan scanBody(const ArticulatedBody& body, const ScanOptions& options) {
  check(body, options);
  return ScanBuilder(body, options).build();
}

std::vector<VertexPair> groundTruth(const SimulatedScan& source, const SimulatedScan& target) {
  return nearestPairs(source.rest_position, target.rest_position, REACH * target.spacing);
}

std::vector<VertexPair> mirrorTruth(const SimulatedScan& source, const SimulatedScan& target) {
  return nearestPairs(
      mirrored(source.rest_position), target.rest_position, REACH * target.spacing + ASYMMETRY);
}

}  // namespace posture
