// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace posture {

/// Normalised mean-value weights of a place by the corners of a polygon, in the plane of its frame;
/// nothing where they cancel or the frame is not sound.
/// \param any  whether any polygon with an area will do.
std::optional<std::vector<double>> meanValueWeights(const Eigen::Vector3d& place,
                                                    const std::vector<Eigen::Vector3d>& corners,
                                                    bool any);

}  // namespace posture
