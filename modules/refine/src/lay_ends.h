// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/surface.h>

#include <Eigen/Geometry>

#include "closest_pairs.h"
#include <limits>
#include <vector>

namespace posture {

/// Motions that turn by less from each other are one.
constexpr double SAME_TURN = M_PI / 6;

/// The end of a limb and what is around it.
struct LimbEnd {
  std::vector<int> wide;     ///< vertices of the end and as much around it
  std::vector<char> inside;  ///< for each of them, whether it is of the end
  Points places, normals;    ///< of `wide`
  std::size_t size = 0;      ///< vertices of the end
  std::size_t on_rim = 0;    ///< of them
  double squared_edge = 0;   ///< mean, of the end
};

/// Mean geodesic distance of each vertex from places all over the surface. The first vertices are
/// spread evenly.
Vector remoteness(const SpectralSurface& surface);

/// The end of the limb at a tip.
/// \param remote  by remoteness(): ears and noses beside the tip are remoter than what is around.
LimbEnd endAt(const SpectralSurface& surface, const Vector& remote, int tip);

/// Whether all of an end was seen, but for a face or two.
bool isWhole(const LimbEnd& end);

/// Its mirror image: the left hand of a right one.
LimbEnd mirrorImage(LimbEnd end);

/// An end laid on another one.
struct LaidEnd {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  double misfit = std::numeric_limits<double>::infinity();
  std::vector<ClosestPair> pairs;  ///< rows of both, without the farthest

  bool operator<(const LaidEnd& other) const { return misfit < other.misfit; }
};

/// Of the rotations of two motions from each other.
double angleBetween(const LaidEnd& x, const LaidEnd& y);

/// As the map lays it: its motion alone.
LaidEnd asMapped(const SpectralSurface& b, const LimbEnd& a, const VertexMaps& maps);

/// The best ways to lay an end on another one, each turned against the better ones; best first, at
/// least one.
/// \param mapped  as a map lays it: one of the ways that are tried.
std::vector<LaidEnd> waysToLay(const LimbEnd& a, const LimbEnd& b, const LaidEnd& mapped);

}  // namespace posture
