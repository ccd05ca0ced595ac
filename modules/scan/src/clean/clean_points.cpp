// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/clean_points.h"

#include <posture/mesh/handles.h>
#include <posture/mesh/vertex_neighbors.h>

#include "clean/circumspheres.h"
#include "clean/cleanness.h"
#include "clean/curvature_flips.h"
#include "clean/inside_cut.h"
#include "clean/poles.h"
#include "points/in_line.h"
#include "points/neighbors.h"
#include "points/outliers.h"
#include "surface/doubts.h"
#include "surface/finished_surface.h"
#include "surface/repair.h"
#include <algorithm>

namespace posture {
namespace {

/// Above, memory would show; and so dense a scan has no thin parts.
constexpr int MOST_POINTS = 100000;

constexpr int NEIGHBORS = 24;

/// Whether the surface is likely that of the points: nearly all are on it, and it has not the many
/// handles that come of sheets which cross or run closer together than the points show.
bool isPlausible(const PointSurface& surface, int point_count) {
  constexpr double ENOUGH = 0.95;
  constexpr double HANDLES = 2, HANDLES_PER_POINT = 1e-3;
  std::vector<char> on_surface(point_count, 0);
  for (int i : surface.point) on_surface[i] = 1;
  return std::count(on_surface.begin(), on_surface.end(), 1) >= ENOUGH * point_count &&
         Handles(surface.mesh).count() <= HANDLES + HANDLES_PER_POINT * point_count;
}

/// Whether most points lie along curves, of which tetrahedra are as many as pairs of points.
bool areAlongCurves(const Points& points, const NeighborTable& neighbors) {
  Eigen::Index in_line = 0;
  for (int i = 0; i < points.rows(); ++i) in_line += isInLine(points, neighbors, i);
  return 2 * in_line > points.rows();
}

/// Leaves each point the vertex of most neighbours. The others are moved a little into their own
/// sheets: what reads the mesh may join vertices at the same place.
void separate(PointSurface& surface, int point_count) {
  constexpr double SHIFT = 1e-3;
  Points& vertices = surface.mesh.vertices;
  const int n = static_cast<int>(vertices.rows());
  const VertexNeighbors neighbors(surface.mesh.faces, n);
  const auto degree = [&](int v) { return neighbors.end(v) - neighbors.begin(v); };
  std::vector<int> stays(point_count, -1);
  for (int v = 0; v < n; ++v) {
    int& first = stays[surface.point[v]];
    if (first < 0 || degree(v) > degree(first)) first = v;
  }
  const Points before = vertices;
  for (int v = 0; v < n; ++v) {
    if (stays[surface.point[v]] == v) continue;
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for (const int* w = neighbors.begin(v); w != neighbors.end(v); ++w)
      mean += before.row(*w) / static_cast<double>(degree(v));
    vertices.row(v) += SHIFT * (mean - before.row(v));
    surface.point[v] = -1;
  }
}

/// Pin holes along the rim of what was seen are closed by faces of the back, too.
void leaveOutBacks(const Points& to_eye, PointSurface& surface) {
  TriangleMesh& mesh = surface.mesh;
  const Points towards = to_eye(surface.point, Eigen::all);
  std::vector<int> facing;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    if (!looksAway({mesh.faces(f, 0), mesh.faces(f, 1), mesh.faces(f, 2)}, mesh.vertices, towards))
      facing.push_back(f);
  const Faces faces = mesh.faces(facing, Eigen::all);
  mesh.faces = largestFans(faces, static_cast<int>(mesh.vertices.rows()));
  std::vector<int> kept;
  mesh = withoutLooseVertices(mesh, kept);
  for (int& v : kept) v = surface.point[v];
  surface.point = std::move(kept);
}

}  // namespace

std::optional<PointSurface> surfaceOfCleanPoints(const Points& given,
                                                 const OutsideHints& given_hints,
                                                 ReconstructionSummary& summary) {
  if (given.rows() > MOST_POINTS) return std::nullopt;
  const NeighborTable near_given = NeighborSearch(given).table(NEIGHBORS);
  const std::vector<char> belongs = withoutStrays(given, near_given, spacing(given, near_given));
  std::vector<int> kept;
  for (int i = 0; i < given.rows(); ++i)
    if (belongs[i]) kept.push_back(i);
  if (kept.empty()) return std::nullopt;
  const Points points = given(kept, Eigen::all);
  const OutsideHints hints = rowsOf(given_hints, kept);

  const int n = static_cast<int>(points.rows());
  const NeighborTable neighbors = NeighborSearch(points).table(NEIGHBORS);
  const Spacing h = spacing(points, neighbors);
  const Cleanness scatter = cleanness(points, neighbors, h);
  if (!scatter.is_clean || areAlongCurves(points, neighbors)) return std::nullopt;
  const std::optional<Tetrahedra> tetrahedra = delaunay(points);
  if (!tetrahedra) return std::nullopt;
  const Stars stars = starsOf(*tetrahedra, n);
  const Circumspheres spheres(points, *tetrahedra);
  OrientationSummary orientation;
  const Points normals = poleNormals(points, stars, spheres, h, hints, orientation);
  const std::vector<char> inside = insideByCut(points, stars, spheres, normals);
  const Points to_eye = orientation.is_one_view ? hints.directions : Points(0, 3);
  PointSurface surface = boundaryOfInside(points, *tetrahedra, inside, h, to_eye);

  int dropped = 0;
  std::vector<int> on_surface;
  surface.mesh = repaired(std::move(surface.mesh), h.median, on_surface, dropped);
  surface.mesh.faces = withLessCurvature(surface.mesh);
  for (int& v : on_surface) v = surface.point[v];
  surface.point = std::move(on_surface);
  if (to_eye.rows() > 0) leaveOutBacks(to_eye, surface);
  if (!isPlausible(surface, n)) return std::nullopt;

  const Points vertex_normals = normals(surface.point, Eigen::all);
  separate(surface, n);
  summary.through_points = true;
  summary.spacing = summary.mesh_spacing = h.median;
  summary.noise = scatter.noise * h.median;
  summary.dropped_pieces = dropped;
  summary.oriented_by_sensor = orientation.by_sensor;
  summary.oriented_by_normals = orientation.by_normals;
  describe(surface.mesh, h.median, summary);
  summary.contacts = possibleContacts(surface.mesh, vertex_normals, h.median);
  for (int& i : surface.point)
    if (i >= 0) i = kept[i];
  return surface;
}

}  // namespace posture
