// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/clean_mesh.h>

#include <optional>
#include <vector>

namespace posture {

/// The input, its faces as facedAlike(), without those that touch the clean vertices.
TriangleMesh withoutVertices(const TriangleMesh& input,
                             const CleanMesh& clean,
                             const std::vector<int>& vertices);

/// The main surface of what is left of an input, looking the way most of that does; nothing where
/// it is too little.
std::optional<CleanMesh> cleanRest(const TriangleMesh& cut);

}  // namespace posture
