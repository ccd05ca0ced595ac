// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "given_shape.h"
#include "refined_maps.h"
#include "refined_shape.h"

namespace posture {

/// A map between the full meshes of both shapes.
struct FullMap {
  BentPair pair;
  std::vector<FacePoint> places;      ///< of the source's vertices on the target
  std::vector<char> without_partner;  ///< the target has no such place
  bool laid = false;                  ///< found by laying the surfaces over each other
};

/// Takes a map from the work meshes to all vertices of both shapes.
FullMap toFullResolution(const RefinedShape& source,
                         const RefinedShape& target,
                         const RefinedMap& map);

/// The same map from the target to the source. \param source  scaled to the target.
FullMap reversed(const RefinedShape& source, const RefinedShape& target, const FullMap& map);

/// n, in (0, 1]: whether the way there and back ends where it began.
Vector roundTripConfidence(const TriangleMesh& source, const VertexMaps& maps);

/// A full map in terms of the vertices and faces as they were given.
/// \param trust  in the whole map: each point is trusted so much at most.
Correspondence correspondenceOf(const GivenShape& source,
                                const RefinedShape& source_shape,
                                const GivenShape& target,
                                const RefinedShape& target_shape,
                                const FullMap& map,
                                double trust);

/// A map of the work meshes in terms of the vertices as they were given, to the spacing of these
/// meshes and for the main surface alone: enough to tell answers apart. Trusted fully.
Correspondence roughCorrespondenceOf(const GivenShape& source,
                                     const RefinedShape& source_shape,
                                     const GivenShape& target,
                                     const RefinedShape& target_shape,
                                     const RefinedMap& map);

/// The map of a coarse finalist in the numbering of the input.
std::vector<int> coarseToInput(const VertexMaps& maps,
                               const GivenShape& source,
                               const RefinedShape& source_shape,
                               const GivenShape& target,
                               const RefinedShape& target_shape);

}  // namespace posture
