// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>

#include <vector>

namespace posture {

/// One mesh with two sets of vertex positions (section 5.1): with either it approximates that
/// shape.
struct CommonMesh {
  Faces faces;
  Points source;  ///< c x 3, on S(0)
  Points target;  ///< c x 3, on S(1)
};

/// The common meshes on corresponding vertices, one collapsed from each side.
struct CommonMeshes {
  CommonMesh from_source;  ///< M(0)
  CommonMesh from_target;  ///< M(1)
};

/// \param pairs  one-to-one: no vertex of either side twice.
CommonMeshes computeCommonMeshes(const TriangleMesh& source,
                                 const TriangleMesh& target,
                                 const std::vector<VertexPair>& pairs);

/// E(M) of section 5.2: the sum over the edges of (source length - target length)^2, in squared
/// mesh units. Infinity for a mesh without edges: nothing speaks for it.
double deformationEnergy(const CommonMesh& mesh);

}  // namespace posture
