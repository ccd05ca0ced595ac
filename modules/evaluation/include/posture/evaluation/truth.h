// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace posture {

/// The known pairs of two shapes: the word `identity` (same numbering on both), or a file of
/// `source_vertex target_vertex` rows.
/// \throws InputError  the file cannot be read or names a vertex that is not there; `identity` for
///         shapes of different size.
std::vector<VertexPair> readTruth(const std::filesystem::path& truth,
                                  int source_vertices,
                                  int target_vertices);

/// That each place of a map lies on a mesh, in a face around its vertex where it has one.
/// \throws InputError  it does not; names the row, counted from 0. `name` begins the message.
void checkOnTarget(const std::string& name,
                   const std::vector<SurfacePoint>& on_target,
                   const TriangleMesh& target);

}  // namespace posture
