// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Handles of an oriented manifold mesh and the closed paths that open them.
class Handles {
 public:
  /// \throws std::invalid_argument  not manifold or not oriented: see cutNonManifold().
  explicit Handles(const TriangleMesh& mesh);

  /// The genus of the surface with its holes closed, summed over its connected parts: a sphere, a
  /// disk and an open tube have 0, a ring 1.
  int count() const { return count_; }

  /// Closed paths along edges, two for each handle of the connected part of `base`, none of which
  /// bounds a part of the surface: the shortest such system through `base`, each without the way
  /// from `base` to where it begins. Erickson and Whittlesey, Greedy optimal homotopy and homology
  /// generators, 2005. \return  vertices in order, the first not repeated; the shortest path first.
  std::vector<std::vector<int>> loopsThrough(int base) const;

 private:
  struct Side {
    int a, b;        // the edge's ends
    int one, other;  // the faces beside it; each hole counts as a face
    double length;
  };
  struct Step {
    int vertex, side;
  };

  int vertices_, regions_ = 0, count_ = 0;
  std::vector<Side> sides_;
  std::vector<int> first_;  // vertices + 1
  std::vector<Step> steps_;
};

}  // namespace posture
