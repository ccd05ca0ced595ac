// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>

#include <filesystem>
#include <vector>

namespace posture {

/// correspondence.csv: `source,target,face,b0,b1,b2,confidence`, one row per source vertex in
/// order. \throws InputError  as readMesh.
Correspondence readCorrespondence(const std::filesystem::path& path);
void writeCorrespondence(const std::filesystem::path& path, const Correspondence& correspondence);

/// Rows `source_vertex target_vertex`, blank-separated, 0-based; blank lines and # comments
/// skipped. \throws InputError  as readMesh.
std::vector<VertexPair> readVertexPairs(const std::filesystem::path& path);
void writeVertexPairs(const std::filesystem::path& path, const std::vector<VertexPair>& pairs);

}  // namespace posture
