// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <string>
#include <vector>

namespace posture {

/// Connectivity of an oriented manifold triangle mesh, with boundary or without, that can be
/// collapsed edge by edge.
///
/// Half-edges are numbers: 3 f + k runs from corner k of face f to the next corner. Removed faces
/// keep their numbers and are skipped. Invariants, all tested by check():
///  1. a live half-edge has a live origin; the three origins of a face differ;
///  2. twin(twin(h)) = h, and twin(h) runs the other way; -1 at the boundary;
///  3. no two live half-edges run between the same two vertices in the same direction;
///  4. outgoing(v) is a live half-edge from v, the one without a clockwise neighbour (its twin is
///     -1) when v is on the boundary; -1 when v has no face left;
///  5. turning about v from outgoing(v) meets every live half-edge from v (one fan a vertex).
class HalfEdgeMesh {
 public:
  /// \throws std::invalid_argument  not manifold or not oriented: see cutNonManifold().
  HalfEdgeMesh(const Faces& faces, int vertex_count);

  int origin(int h) const { return origin_[h]; }
  int target(int h) const { return origin_[next(h)]; }
  int twin(int h) const { return twin_[h]; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int outgoing(int v) const { return outgoing_[v]; }

  int halfEdgeCount() const { return static_cast<int>(origin_.size()); }  ///< removed ones included
  int vertexCount() const { return static_cast<int>(outgoing_.size()); }  ///< removed ones included
  int liveVertexCount() const;
  int liveFaceCount() const;
  bool isLive(int h) const { return origin_[h] >= 0; }
  bool isBoundaryVertex(int v) const { return outgoing_[v] >= 0 && twin_[outgoing_[v]] < 0; }

  /// Live half-edges from v, counter-clockwise.
  std::vector<int> star(int v) const;

  /// Vertices joined to v by an edge; on the boundary including the one no half-edge of v reaches.
  std::vector<int> neighbors(int v) const;

  /// The live half-edges without a twin, a list a hole, in the order in which their faces have
  /// them.
  std::vector<std::vector<int>> boundaryLoops() const;

  /// Whether moving `from` into its neighbour `into` keeps a manifold of the same topology: the
  /// link condition (Dey et al. 1999), with the boundary closed by a vertex of its own.
  bool canCollapse(int from, int into) const;

  /// Moves `from` into its neighbour `into`: their one or two common faces go.
  /// \pre canCollapse(from, into)
  void collapse(int from, int into);

  /// Whether the edge of h has two faces and turning it keeps a manifold: its new ends are not
  /// joined yet, and its old ones keep a closed fan.
  bool canFlip(int h) const;

  /// Turns the edge of h: of the quadrilateral of its two faces, it then joins the other two
  /// corners. \pre canFlip(h)
  void flip(int h);

  /// The live faces, in the numbering of the vertices given.
  Faces faces() const;

  /// Empty when every invariant holds, otherwise the first that does not.
  std::string check() const;

 private:
  int find(int from, int to) const;
  void resetOutgoing(int v, int any_live_half_edge);
  void removeFace(int h);

  std::vector<int> origin_;    // -1: removed
  std::vector<int> twin_;      // -1: boundary
  std::vector<int> outgoing_;  // -1: no face
};

/// A mesh cut apart along edges of more than two faces or of faces that disagree in orientation,
/// and at vertices where several fans meet.
struct ManifoldMesh {
  TriangleMesh mesh;                 ///< first the vertices given, then the copies
  std::vector<int> original_vertex;  ///< vertex -> vertex of the mesh given
};

ManifoldMesh cutNonManifold(const TriangleMesh& mesh);

}  // namespace posture
