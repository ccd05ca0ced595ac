// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/clean_sides.h"

#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/mesh/denoise.h>

#include <stdexcept>
#include <vector>

namespace posture {
namespace {

/// Takes out of the summary what cleanMesh() counts only since faces of the background are
/// collapsed.
void forgetBackground(const SideSurface& surface, CleanMesh& clean) {
  const Background& background = surface.background;
  if (background.faces == 0) return;
  std::vector<char> is_corner(background.vertices.size(), 0);
  for (int v : surface.mesh.faces.reshaped()) is_corner[v] = 1;
  int unreferenced = background.left_over, loose = 0;
  for (std::size_t v = 0; v < is_corner.size(); ++v)
    if (background.vertices[v] != 0) {
      unreferenced += is_corner[v] == 0;
      // One at the place of the body's own is on the main surface.
      loose += is_corner[v] != 0 && !clean.isOnMain(static_cast<Eigen::Index>(v));
    }
  clean.summary.degenerate_faces -= background.faces;
  clean.summary.unreferenced_vertices -= unreferenced;
  clean.summary.loose_vertices -= loose;
}

CleanMesh cleanSide(const std::string& side, SideSurface& surface) {
  return naming(side, [&] {
    if (!surface.scan) surface.denoising = denoise(surface.mesh);
    surface.background = leaveOutBackground(surface.mesh);
    CleanMesh clean = cleanMesh(surface.mesh);
    forgetBackground(surface, clean);
    return clean;
  });
}

/// Turns a surface that does not tell its outside, if the other one was inside out.
void turnAsOther(const CleanMesh& other, CleanMesh& clean) {
  if (!clean.outward_known && other.outward_known && other.inside_out) turnOver(clean);
}

}  // namespace

CleanSides cleanSides(SideSurface& source, SideSurface& target) {
  CleanSides clean;
  inParallel([&] { clean.source = cleanSide("source", source); },
             [&] { clean.target = cleanSide("target", target); });
  if (source.scan || target.scan) return clean;
  turnAsOther(clean.target, clean.source);
  turnAsOther(clean.source, clean.target);
  return clean;
}

std::vector<StagePicture> cleaningPictures(const CleanMesh& source, const CleanMesh& target) {
  return {{"source-main-surface", source.mesh, source.mesh.vertices, {}},
          {"target-main-surface", target.mesh, target.mesh.vertices, {}}};
}

}  // namespace posture
