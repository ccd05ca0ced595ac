// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include "field.h"

namespace posture::synthesis {

/// About `vertices` vertices (within a few per cent) on the skin of the field, triangles near
/// equilateral, finer where the field asks for detail. The surface stays closed, manifold, of the
/// same genus. \see Botsch & Kobbelt, A Remeshing Approach to Multiresolution Modeling, SGP 2004.
TriangleMesh remesh(const TriangleMesh& mesh, const FleshField& field, int vertices);

}  // namespace posture::synthesis
