// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/synthesis/ray_caster.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace posture {

/// A pinhole camera. In its own frame it looks along +z, +x is to the right, +y down.
struct DepthCamera {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  int width = 0, height = 0;  ///< pixels
  double focal = 1;           ///< pixels

  /// Through the middle of a pixel or beside it; z = 1, in the camera's frame.
  Eigen::Vector3d ray(double column, double row) const {
    return {(column + 0.5 - 0.5 * width) / focal, (row + 0.5 - 0.5 * height) / focal, 1};
  }
};

/// What is wrong with a depth image. Lengths in the unit of the world.
///
/// Noise and steps are those of a camera that triangulates (structured light, stereo): both grow
/// with the square of the depth (Khoshelham and Elberink, Accuracy and Resolution of Kinect Depth
/// Data, 2012, eq. 5), the noise also where the surface is seen aslant (Nguyen, Izadi, Lovell,
/// Modeling Kinect Sensor Noise, 2012).
struct DepthDefects {
  double noise = 0;  ///< standard deviation in z at reference_depth, seen head-on
  double step = 0;   ///< between two measurable depths there
  double reference_depth = 1;
  double jitter = 0;       ///< standard deviation of where in the image it looks, pixels
  double lost_aslant = 0;  ///< cosine of the incidence below which every return is lost;
                           ///< up to twice that ever fewer are
  double depth_edge = 0;   ///< neighbouring pixels differing by more are a silhouette
  double flying = 0;       ///< share of the silhouette's pixels measured somewhere between the
                           ///< depths there
  double outliers = 0;     ///< share of all pixels' returns that are anywhere near
};

/// A depth image, pixel by pixel, row after row.
struct DepthImage {
  Vector depth;             ///< z in the camera's frame; NaN: no return
  std::vector<RayHit> hit;  ///< what a pixel saw; face -1: nothing, or what it says is not there
};

/// The same for any number of threads.
DepthImage takeDepthImage(const RayCaster& scene,
                          const TriangleMesh& mesh,
                          const DepthCamera& camera,
                          const DepthDefects& defects,
                          std::uint64_t seed);

}  // namespace posture
