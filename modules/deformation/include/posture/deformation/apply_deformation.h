// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>
#include <posture/core/types.h>

namespace posture {

/// Takes points along with a surface that was deformed: markers, a denser scan, another surface.
///
/// Each vertex carries a local frame (the rotation that best takes its surroundings to how they
/// lie now; all share one scale); a point goes where the frames near it would have it, by an
/// inverse-distance blend with bounded reach (Shepard 1968; Franke and Little 1982), over vertices
/// that are joined to the nearest one within that reach: parts that touch do not drag each other.
/// A vertex of the source goes exactly where it went. The map is smooth but where the nearest part
/// of the surface changes. A point more than eight edges off goes where the frames would have it
/// that blend eight edges from the surface, below it.
/// \param source    its vertices and faces at rest.
/// \param deformed  n x 3, where the vertices went.
/// \param points    p x 3, in the frame and unit of the source.
/// \return p x 3, in those of `deformed`.
/// \throws std::invalid_argument  sizes that do not agree, or no vertices; as requireMesh().
Points applyDeformation(const TriangleMesh& source, const Points& deformed, const Points& points);

/// Turns directions, say normals, at points by the same blend of the frames near them.
/// \param directions  p x 3, one a point, of any length, which each keeps.
/// \throws std::invalid_argument  as applyDeformation.
Points turnDirections(const TriangleMesh& source,
                      const Points& deformed,
                      const Points& points,
                      const Points& directions);

/// A surface and where its vertices went.
struct DeformedSurface {
  TriangleMesh rest;
  Points deformed;  ///< one row a vertex
};

/// Points and their normals taken along. Points that are not finite stay as they are, as do normals
/// there and those that are not finite or of no length. \throws std::invalid_argument  as above.
PointCloud applyDeformation(const DeformedSurface& surface, PointCloud cloud);

/// The normals of a cloud at rest, turned so; none, where it has none.
Points turnedNormals(const DeformedSurface& surface, const PointCloud& cloud);

/// For any mesh the surface that points are best taken along with: facets that do not share
/// vertices are joined where these are at one place, and vertices in no face, which have no frame
/// of their own, are left out. \throws InputError  as cleanMesh.
DeformedSurface joinedSurface(const TriangleMesh& source, const Points& deformed);

}  // namespace posture
