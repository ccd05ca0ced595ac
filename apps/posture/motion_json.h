// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "json_document.h"

namespace posture::app {

/// A rigid motion: `rotation`, rows of a matrix, the same as `quaternion_wxyz`, `translation`.
Json toJson(const Eigen::Isometry3d& motion);

}  // namespace posture::app
