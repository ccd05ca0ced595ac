// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace posture {

/// PCL's registrations of a source that moves as a whole, set up as PCL's documentation and
/// tutorials advise, with the same figures for all shapes: docs/comparison.md. The local ones start
/// where the source is; the last one needs no start.
enum class RigidMethod {
  ICP,                 ///< point to point (Besl and McKay 1992)
  ICP_POINT_TO_PLANE,  ///< Chen and Medioni 1992, linearised (Low 2004)
  GICP,                ///< plane to plane (Segal, Haehnel and Thrun 2009)
  NDT,                 ///< normal distributions transform (Magnusson 2009)
  FPFH_ICP             ///< features (Rusu 2009) with sample consensus (Buch 2013), then ICP
};

/// In the order of the enumeration.
const std::vector<RigidMethod>& rigidMethods();

/// "ICP", "ICP point to plane", "GICP", "NDT", "FPFH + ICP".
std::string nameOf(RigidMethod method);

/// The same as one word of small letters: "icp", "icp-point-to-plane", "gicp", "ndt", "fpfh-icp".
std::string keyOf(RigidMethod method);

struct RigidResult {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  bool converged = false;  ///< as PCL says, which may be of a wrong place
  std::string failure;     ///< why there is no motion, in one line; empty: there is one
};

/// Moves the source onto the target. No scale is estimated: none of these methods does. Points that
/// are not finite are left out. Normals that are given (unit length, zero: unknown) are used by the
/// methods that need some, otherwise they are estimated by PCL.
/// \param seed  of std::rand, which PCL draws from and which is seeded here (FPFH_ICP alone).
/// \throws InputError  fewer than 10 finite points on a side, or all at one place; coordinates too
///         large or too small to compute with.
RigidResult registerRigidly(RigidMethod method,
                            const PointCloud& source,
                            const PointCloud& target,
                            std::uint64_t seed = 1);

}  // namespace posture
