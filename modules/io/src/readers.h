// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/io/mesh_io.h>

#include "input.h"
#include <string_view>

namespace posture {

MeshFile readPly(const Input& input);
MeshFile readObj(const Input& input);
MeshFile readOff(const Input& input);
MeshFile readStl(const Input& input);
MeshFile readVtk(const Input& input);

/// OFF with any of the prefixes ST, C, N, 4, n.
bool isOffKeyword(std::string_view word);
/// Exactly as long as a binary STL file with its number of facets is.
bool isBinaryStl(std::string_view bytes);

}  // namespace posture
