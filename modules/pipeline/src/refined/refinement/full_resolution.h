// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/refinement/refined_maps.h"
#include "refined/work/refined_shape.h"
#include <vector>

namespace posture {

/// A map between the full meshes of both shapes.
struct FullMap {
  BentPair pair;
  std::vector<FacePoint> places;      ///< of the source's vertices on the target
  std::vector<char> without_partner;  ///< the target has no such place
  HowFound found;                     ///< of the map between the work meshes
};

/// How many meshes between a side's work mesh and its full one a map is taken by.
int levelsBetween(const RefinedShape& shape);

/// Takes a map from the work meshes to all vertices of both shapes; of large meshes by way of some
/// that are reduced less.
FullMap toFullResolution(const RefinedShape& source,
                         const RefinedShape& target,
                         const RefinedMap& map);

/// The same map from the target to the source. \param source  scaled to the target.
FullMap reversed(const RefinedShape& source, const RefinedShape& target, const FullMap& map);

}  // namespace posture
