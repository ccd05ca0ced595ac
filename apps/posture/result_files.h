// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>
#include <posture/pipeline/register_shapes.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace posture::app {

/// What writeResultFiles() writes: name, what it holds.
std::vector<std::pair<std::string, std::string>> resultFiles(const RegistrationResult& result);

/// The correspondence, the deformed source, both shapes in colours, the surfaces laid through
/// clouds, and the alternatives that were taken to full precision.
void writeResultFiles(const std::filesystem::path& folder,
                      const Shape& source,
                      const Shape& target,
                      const RegistrationResult& result);

/// Rows `point,vertex,face,b0,b1,b2,offset`: where each point of a cloud lies on its surface.
void writeSurfaceLink(const std::filesystem::path& path, const ScanSurface& surface);

}  // namespace posture::app
