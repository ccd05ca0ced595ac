// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/clean_mesh.h>

#include <vector>

namespace posture {

/// An input's main surface that parts are cut out of.
class CutSurface {
 public:
  /// \param input  referred to.
  /// \param clean  of it.
  CutSurface(const TriangleMesh& input, CleanMesh clean);

  /// Cuts out the faces that touch some clean vertices; the main surface of what is left looks the
  /// way most of that did, what was cut out is turned as before.
  /// \return  false: too little would be left, and all stays as it is.
  bool cutOut(const std::vector<int>& vertices);

  /// In the whole input's numbering, also after cuts; its summary is of what was left.
  const CleanMesh& clean() const { return clean_; }

  /// Of each face of the input whether it was cut out.
  const std::vector<char>& gone() const { return gone_; }

 private:
  const TriangleMesh& input_;
  CleanMesh clean_;
  std::vector<char> gone_;  // each face of the input
};

}  // namespace posture
