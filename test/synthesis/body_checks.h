// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/synthesis/articulated_body.h>

#include <vector>

namespace posture::test {

/// What a triangle mesh is as a surface, counted from its edges alone.
struct Topology {
  bool manifold = true;  ///< at most two faces an edge, running opposite ways; one fan a vertex
  int components = 0;
  int euler = 0;
  int rims = 0;  ///< boundary loops
};
Topology topologyOf(const TriangleMesh& mesh);

double volumeOf(const TriangleMesh& mesh);  ///< > 0: oriented outwards
double meanEdgeOf(const TriangleMesh& mesh);
double smallestAngleOf(const TriangleMesh& mesh);  ///< degrees

/// |length in the pose / length in the rest pose - 1| of every edge, ascending.
std::vector<double> edgeChangesOf(const ArticulatedBody& body);

/// Pairs of faces without a common corner that cut each other.
int countSelfIntersections(const TriangleMesh& mesh);

}  // namespace posture::test
