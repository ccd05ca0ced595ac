// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "given_shape.h"
#include "pose.h"
#include "refined_result.h"
#include "refined_shape.h"

namespace posture {

/// A side with its working meshes, and how these lie to it as given.
struct PosedSide {
  const GivenShape& given;
  RefinedShape shape;  ///< the source's scaled to the target
  const Pose& pose;
};

/// The other direction of a full map, in terms of the vertices and faces as they were given.
/// \param result  of the way there: correspondence, scale and trust are set.
WayBack wayBack(const PosedSide& source,
                const PosedSide& target,
                const FullMap& there,
                const RegistrationResult& result);

/// How well both ways agree, into the way back.
void measureMiss(const GivenShape& source,
                 const TriangleMesh& target,
                 const Correspondence& there,
                 WayBack& back);

}  // namespace posture
