// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace posture::app {

/// A rigid motion: `rotation`, rows of a matrix, the same as `quaternion_wxyz`, `translation`.
nlohmann::ordered_json toJson(const Eigen::Isometry3d& motion);

}  // namespace posture::app
