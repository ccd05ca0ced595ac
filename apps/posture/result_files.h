// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/pipeline/segment_shape.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace posture::app {

/// What writeResultFiles() writes: name, what it holds.
std::vector<std::pair<std::string, std::string>> resultFiles(const RegistrationResult& result,
                                                             bool with_segments);

/// The correspondence, the deformed source, both shapes in colours, the surfaces laid through
/// clouds, the near-rigid parts where there are any, and the alternatives that were taken to full
/// precision.
void writeResultFiles(const std::filesystem::path& folder,
                      const Shape& source,
                      const Shape& target,
                      const RegistrationResult& result,
                      const std::optional<ShapeSegments>& segments);

/// That none of the inputs is a file that a result in this folder takes the place of.
/// \throws InputError  one is; names it.
void requireNoResultFiles(const std::filesystem::path& folder,
                          const std::vector<std::filesystem::path>& inputs);

/// The same for what `segment` writes.
void requireNoSegmentFiles(const std::filesystem::path& folder,
                           const std::vector<std::filesystem::path>& inputs);

/// That a file is no part of the result in a folder. \throws InputError  it is.
void requireNoPartOfResult(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Takes an earlier result out of a folder, also one that was being written: the report first, then
/// all that has a name of writeResultFiles(), and what `segment` wrote: the parts are now others.
void removeResultFiles(const std::filesystem::path& folder);

/// What `segment` wrote, segments.json first. Both verbs write a segments.ply: where a result of
/// `register` is there, it is left.
void removeSegmentFiles(const std::filesystem::path& folder);

/// A mesh stays a mesh, a cloud a cloud.
void writeColored(const std::filesystem::path& path,
                  const Points& points,
                  const Faces& faces,
                  const Colors& colors);

/// The shape in the colours of its parts, which are returned: one a vertex (point).
Colors writeSegments(const std::filesystem::path& path,
                     const Shape& shape,
                     const ShapeSegments& segments);

/// Rows `point,vertex,face,b0,b1,b2,offset`: where each point of a cloud lies on its surface.
void writeSurfaceLink(const std::filesystem::path& path, const ScanSurface& surface);

}  // namespace posture::app
