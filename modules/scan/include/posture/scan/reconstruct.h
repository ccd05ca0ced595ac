// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/point_cloud.h>

#include <string>
#include <vector>

namespace posture {

/// How the surface is laid through the points. The first is this project's own; the others are
/// PCL's, with parameters derived from the spacing. See docs/decisions/reconstruction.md.
enum class SurfaceMethod {
  /// Own: smoothing, then Delaunay stars in the tangent planes; for points without noise, as the
  /// vertices of a mesh are, the boundary between the inside and the outside of their tetrahedra.
  TANGENT_DELAUNAY,
  MLS,      ///< PCL's moving least squares, then the same triangulation
  POISSON,  ///< PCL's Poisson surface, cut back to where there are points
  GREEDY,   ///< PCL's greedy projection
};

struct ReconstructionOptions {
  SurfaceMethod surface = SurfaceMethod::TANGENT_DELAUNAY;
};

/// What was found on the way. Lengths are in the unit of the cloud.
struct ReconstructionSummary {
  int points = 0;
  int missing = 0;         ///< not finite
  int repeated = 0;        ///< at the very place of another
  int outliers = 0;        ///< places, alone or in a group too small to be a part
  int dropped_pieces = 0;  ///< pieces of surface too small to keep
  /// The points have no noise and are the vertices; otherwise the surface is laid through noise.
  bool through_points = false;
  double spacing = 0;  ///< of the points: the side of the square each one stands for
  /// Median of the root mean square distance of ten neighbours from their plane; where the surface
  /// goes through the points, the most that their distance from curved neighbourhoods allows.
  double noise = 0;
  double mesh_spacing = 0;  ///< of the vertices
  int averaged = 0;         ///< neighbours averaged into one point first; 0: the noise was small
  int vertices = 0;
  int faces = 0;
  int components = 0;
  int boundary_loops = 0;
  double boundary_length = 0;
  bool double_walls = false;         ///< views that do not fit each other, or noise without end
  bool oriented_by_sensor = false;   ///< a scanner's place, or the grid of a view
  bool oriented_by_normals = false;  ///< the normals given decided the side, at least of a part
  double thin = 0;   ///< share of the vertices where the part is thinner than the mesh can show
  int contacts = 0;  ///< places where parts that touch may have been joined
  std::vector<std::string> warnings;  ///< a sentence each
};

struct ScanSurface {
  TriangleMesh mesh;  ///< manifold, oriented, holes open; in the cloud's frame; maybe in components
  std::vector<SurfacePoint> on_mesh;  ///< n: the place nearest to each point; vertex -1: the point
                                      ///< is missing or an outlier
  Vector offset;                      ///< n, distance of the point to that place; 0 where none
  ReconstructionSummary summary;
};

/// A triangle mesh through the points of a scan. Points without noise are themselves its vertices.
/// All scales come from the points; the same points in another order, or moved, give the same mesh
/// up to rounding. Faces are counter-clockwise seen from outside: from the sensor where known, else
/// as the grid of a depth image is seen, else from the origin where open points without normals lie
/// ahead of it and look as seen from there (which moving them may change), else away from the
/// inside of the body.
///
/// \throws InputError  no finite point; too few different points; all on one line; no surface; too
/// large or too small to compute with;
/// std::invalid_argument  normals that are not one a point, a grid of negative width;
/// std::runtime_error  PCL's method is asked for and its library is not installed.
ScanSurface reconstruct(const PointCloud& cloud, const ReconstructionOptions& options = {});

}  // namespace posture
