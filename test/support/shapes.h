// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <cstdint>

namespace posture::test {

/// rows x columns quads cut into triangles over [0, width] x [0, height], z = 0.
TriangleMesh grid(int columns, int rows, double width, double height);

/// The unit sphere: an icosahedron subdivided `levels` times.
TriangleMesh sphere(int levels);

/// A strip of the given length and width, bent along its length into an arc of `angle` radians
/// without stretching: vertex numbering is that of grid().
TriangleMesh bentStrip(int columns, int rows, double length, double width, double angle);

/// A torus about the z axis: `around` x `across` quads cut into triangles, vertex
/// i * across + j at i steps around and j steps across, from the outermost circle.
TriangleMesh torus(int around, int across, double ring_radius, double tube_radius);

/// A closed surface grown together with itself: the faces at two vertices, which must be neither
/// neighbours nor on a boundary, are replaced by a tube between the rings around them. Both
/// vertices are left without a face. One handle more.
TriangleMesh fused(const TriangleMesh& mesh, int a, int b);

/// The second mesh beside the first, whose vertices and faces come first.
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);

TriangleMesh shifted(TriangleMesh mesh, const Eigen::RowVector3d& by);

/// Every corner with a vertex of its own, as STL has them: vertex 3 f + k is corner k of face f.
TriangleMesh soup(const TriangleMesh& mesh);

/// count x 3, each coordinate standard normal.
Points randomPoints(int count, std::uint64_t seed);

/// n x n straight distances.
Matrix pairwise(const Points& points);

}  // namespace posture::test
