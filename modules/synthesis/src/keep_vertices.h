// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/synthesis/articulated_body.h>

#include "scan_defects.h"

namespace posture::synthesis {

/// Reduces a body to what is left of its mesh.
void keepVertices(ArticulatedBody& body, const PunchedMesh& left);

}  // namespace posture::synthesis
