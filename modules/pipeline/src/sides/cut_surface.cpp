// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/cut_surface.h"

#include <posture/core/error.h>

#include <algorithm>
#include <utility>

namespace posture {

CutSurface::CutSurface(const TriangleMesh& input, CleanMesh clean)
    : input_(input), clean_(std::move(clean)), gone_(input.faces.rows(), 0) {}

bool CutSurface::cutOut(const std::vector<int>& vertices) {
  std::vector<char> is_out(clean_.mesh.vertices.rows(), 0);
  for (int v : vertices) is_out[v] = 1;
  const auto touches = [&](int v) {
    return clean_.isOnMain(v) && is_out[clean_.clean_vertex[v]] != 0;
  };
  const Faces faces = facedAlike(input_.faces, clean_);
  std::vector<char> gone = gone_;
  std::vector<int> left;
  for (int f = 0; f < faces.rows(); ++f) {
    const Eigen::RowVector3i face = faces.row(f);
    if (std::any_of(face.data(), face.data() + 3, touches)) gone[f] = 1;
    if (gone[f] == 0) left.push_back(f);
  }
  CleanMesh rest;
  try {
    rest = cleanMesh({input_.vertices, faces(left, Eigen::all)}, Facing::AS_MOST);
  } catch (const InputError&) {
    return false;
  }
  // From the faces that are left, turned alike, to those of the input.
  std::vector<char> on_main(input_.faces.rows(), 0), turned = clean_.face_turned;
  for (std::size_t i = 0; i < left.size(); ++i) {
    on_main[left[i]] = rest.face_on_main[i];
    turned[left[i]] = static_cast<char>(turned[left[i]] != rest.face_turned[i]);
  }
  for (int& f : rest.piece_face) f = left[f];
  rest.face_on_main = std::move(on_main);
  rest.face_turned = std::move(turned);
  rest.inside_out = clean_.inside_out;
  clean_ = std::move(rest);
  gone_ = std::move(gone);
  return true;
}

}  // namespace posture
