// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <filesystem>

namespace posture {

/// A mesh as its file has it: every vertex, in order, referenced or not; polygons cut into
/// triangles, concave ones too.
struct MeshFile {
  TriangleMesh mesh;
  Points normals;  ///< n x 3, or 0 x 3 where the file has none for every vertex
  Colors colors;   ///< n x 3, or 0 x 3
};

/// Reads PLY (ASCII, binary of either endianness), OBJ, OFF (COFF, NOFF, CNOFF; ASCII), STL (ASCII
/// and binary; three vertices a facet, as stored) or legacy VTK (polydata and unstructured grids of
/// polygons, ASCII and binary; positions and faces only). The format is told by the content where
/// it has a signature, by the file's ending otherwise. A file with vertices alone has 0 faces.
/// \throws InputError  one line "<path>: <what is wrong>": missing, empty, truncated, not a mesh,
///         no vertices, a number that is not finite, a face index out of range.
MeshFile readMesh(const std::filesystem::path& path);

/// Writes PLY (binary little endian), OBJ or OFF by the path's ending; whole or not at all.
/// \param colors  n x 3, or empty.
/// \throws InputError  cannot be written; std::invalid_argument  another ending.
void writeMesh(const std::filesystem::path& path,
               const TriangleMesh& mesh,
               const Colors& colors = {});

}  // namespace posture
