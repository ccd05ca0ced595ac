// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>
#include <posture/io/mesh_io.h>

#include "input.h"
#include "mesh_builder.h"
#include <string_view>

namespace posture {

enum class MeshFormat { UNKNOWN, PLY, OBJ, OFF, STL, VTK };

/// By a signature in the content; UNKNOWN where there is none.
MeshFormat signatureOf(const Input& input);
/// By the signature, else by the file's ending.
MeshFormat meshFormatOf(const Input& input);
MeshFile readMeshAs(MeshFormat format, const Input& input, Unseen unseen);

MeshFile readPly(const Input& input, Unseen unseen);
MeshFile readObj(const Input& input, Unseen unseen);
MeshFile readOff(const Input& input, Unseen unseen);
/// Every vertex is the corner of a facet: all have to be finite.
MeshFile readStl(const Input& input);
MeshFile readVtk(const Input& input, Unseen unseen);

PointCloud readPcd(const Input& input);
/// Rows of numbers as in XYZ, PTS and CSV files. The endings .xyzn and .xyzrgb tell what follows x,
/// y and z.
PointCloud readTable(const Input& input);

/// OFF with any of the prefixes ST, C, N, 4, n; or all of it in small letters.
bool isOffKeyword(std::string_view word);
/// Exactly as long as a binary STL file with its number of facets is.
bool isBinaryStl(std::string_view bytes);

}  // namespace posture
