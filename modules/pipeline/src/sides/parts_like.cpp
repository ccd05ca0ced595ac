// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/parts_like.h"

#include <posture/core/unions.h>
#include <posture/deformation/reduce_mesh.h>
#include <posture/geodesic/landmarks.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/refine/place_piece.h>

#include "sides/cut_surface.h"
#include <algorithm>
#include <map>
#include <utility>

namespace posture {
namespace {

/// Distances are compared on so many vertices, between so many samples; more of the whole, which
/// has to tell where those of the piece lie.
constexpr int VERTICES = 3000, PIECE_SAMPLES = 60, WHOLE_SAMPLES = 500, LEAST_SAMPLES = 20;

/// Of the places that distances allow. A symmetric piece has several in the same part.
constexpr int PLACES = 12;

/// Around, in square roots of the area: eyes and a mouth that are holes come to 0.05 to 0.08, a
/// wrist to 0.12. What is cut off at a neck of a hundredth of the body's area, to 0.2.
constexpr double NARROWEST_RIM = 0.1, LEAST_RIM = 0.2;

/// Parts that share this much of what both have are one.
constexpr double SAME_PART = 0.7;

/// A part this large is the whole.
constexpr double NEARLY_ALL = 0.9;

/// A surface in square roots of its area, on fewer vertices.
struct Sampled {
  Sampled(const CleanMesh& clean, int samples)
      : Sampled(clean.mesh, rootArea(clean.mesh), samples) {}

  ReducedMesh reduced;
  Landmarks landmarks;
  Matrix distances;

 private:
  Sampled(const TriangleMesh& mesh, double unit, int samples)
      : reduced(reduceMesh({mesh.vertices / unit, mesh.faces}, VERTICES)),
        landmarks(computeLandmarks(reduced.mesh, FastMarching(reduced.mesh), samples)),
        distances(sampleDistances(landmarks)) {}
};

/// The whole's reduced vertices that the samples of the piece stand for.
std::vector<char> covered(const Sampled& piece, const Sampled& whole, const PiecePlace& place) {
  const auto n = whole.landmarks.distances.cols();
  const double reach = place.scale * piece.landmarks.covering_radius;
  std::vector<char> covered(n, 0);
  for (int sample : place.sample)
    for (Eigen::Index v = 0; v < n; ++v)
      if (whole.landmarks.distances(sample, v) <= reach) covered[v] = 1;
  return covered;
}

/// What two parts have in common, over what they have together.
double overlap(const std::vector<char>& a, const std::vector<char>& b) {
  int both = 0, either = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    both += a[v] && b[v];
    either += a[v] || b[v];
  }
  return either == 0 ? 1 : static_cast<double>(both) / either;
}

/// The length of the rims that a limb may have come out of, in all; those that touch are one.
double rimsOfLimbs(const TriangleMesh& mesh) {
  const std::vector<Edge> edges = meshEdges(mesh.faces);
  const auto n = static_cast<int>(mesh.vertices.rows());
  Unions rims(n);
  for (const Edge& e : edges)
    if (e.faces == 1) rims.join(e.first, e.second);
  std::map<int, double> length;
  for (const Edge& e : edges)
    if (e.faces == 1)
      length[rims.root(e.first)] +=
          (mesh.vertices.row(e.first) - mesh.vertices.row(e.second)).norm();
  const double narrow = NARROWEST_RIM * rootArea(mesh);
  double all = 0;
  for (const auto& [rim, around] : length)
    if (around > narrow) all += around;
  return all;
}

}  // namespace

bool isInPieces(const CleanMesh& surface) {
  constexpr double A_LIMB = 0.02;  // of the area
  const double pieces = surfaceArea(surface.pieces);
  return pieces > A_LIMB * (pieces + surfaceArea(surface.mesh));
}

bool mayBePiece(const CleanMesh& surface) {
  return isInPieces(surface) || rimsOfLimbs(surface.mesh) > LEAST_RIM * rootArea(surface.mesh);
}

std::vector<CleanMesh> partsLike(const CleanMesh& piece, const GivenShape& whole, int most) {
  const Sampled small(piece, PIECE_SAMPLES), large(whole.clean, WHOLE_SAMPLES);
  if (std::min(small.distances.rows(), large.distances.rows()) < LEAST_SAMPLES) return {};
  if (!small.distances.allFinite() || !large.distances.allFinite()) return {};  // no way between
  std::vector<std::vector<char>> parts;
  std::vector<CleanMesh> cut;
  for (const PiecePlace& place : placePiece(small.distances, large.distances, PLACES)) {
    if (static_cast<int>(cut.size()) >= most) break;
    std::vector<char> part = covered(small, large, place);
    if (std::any_of(parts.begin(), parts.end(), [&](const std::vector<char>& known) {
          return overlap(part, known) > SAME_PART;
        }))
      continue;
    std::vector<int> outside;
    const std::vector<int>& nearest = large.reduced.nearest;
    for (std::size_t v = 0; v < nearest.size(); ++v)
      if (!part[nearest[v]]) outside.push_back(static_cast<int>(v));
    parts.push_back(std::move(part));
    if (static_cast<double>(outside.size()) <
        (1 - NEARLY_ALL) * static_cast<double>(nearest.size()))
      continue;
    CutSurface rest(whole.input, whole.clean);
    if (!rest.cutOut(outside)) continue;
    cut.push_back(rest.clean());
    // What else the whole is in says nothing of how this part of it lies.
    cut.back().pieces = {};
    cut.back().piece_vertex.clear();
    cut.back().piece_face.clear();
  }
  return cut;
}

}  // namespace posture
