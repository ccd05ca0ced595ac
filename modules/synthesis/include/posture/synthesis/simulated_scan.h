// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>
#include <posture/synthesis/articulated_body.h>

#include <cstdint>
#include <vector>

namespace posture {

struct ScanOptions {
  /// Depth images from around the body. One: an organised cloud in the camera's frame; more: one
  /// cloud of them all, registered and put into a frame of its own.
  int views = 6;
  int points = 30'000;  ///< about so many
  /// Scales everything a sensor and the registration of the views do wrong. 1: a consumer depth
  /// camera two metres from a person, several images averaged; 0: exact.
  double noise = 1;
  std::uint64_t seed = 1;  ///< of the frame, the unit, where the cameras stand, and the noise
};

/// A scan with what is true of it.
struct SimulatedScan {
  PointCloud cloud;         ///< n points, in the scan's frame and unit
  Points rest_position;     ///< n x 3: the place each shows, as in ArticulatedBody; NaN: none
  std::vector<int> vertex;  ///< n: the body's vertex nearest to that place; -1: none
  TriangleMesh surface;     ///< the body without defects, in the scan's frame and unit
  double unit = 1;          ///< a length of the body times this is one of the scan
  double spacing = 0;       ///< of the rays where they meet the body, in body units
};

/// \throws std::invalid_argument  no views, fewer than 100 points, a negative noise, a body without
///         faces.
SimulatedScan scanBody(const ArticulatedBody& body, const ScanOptions& options);

/// The true counterpart of every source point that shows a place of the body: the target point
/// whose place is nearest, left out where the target has not seen it, that is, within 1.5 spacings.
std::vector<VertexPair> groundTruth(const SimulatedScan& source, const SimulatedScan& target);

/// The same for the answer that took left for right, within more: the body's sides differ.
std::vector<VertexPair> mirrorTruth(const SimulatedScan& source, const SimulatedScan& target);

}  // namespace posture
