// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/synthesis/articulated_body.h>

namespace posture::test {

/// A person of about 2,500 vertices.
inline ArticulatedBody person(int pose, int tessellation = 0) {
  BodyOptions options;
  options.kind = BodyKind::HUMAN;
  options.pose = pose;
  options.vertices = 2500;
  options.tessellation = tessellation;
  return makeBody(options);
}

}  // namespace posture::test
