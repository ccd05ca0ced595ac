// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/synthesis/articulated_body.h>

namespace posture::test {

inline BodyOptions bodyOptions(BodyKind kind,
                               int pose = 0,
                               int tessellation = 0,
                               int vertices = 2500) {
  BodyOptions options;
  options.kind = kind;
  options.pose = pose;
  options.tessellation = tessellation;
  options.vertices = vertices;
  return options;
}

inline ArticulatedBody body(int pose,
                            int vertices,
                            int tessellation = 0,
                            BodyKind kind = BodyKind::QUADRUPED) {
  return makeBody(bodyOptions(kind, pose, tessellation, vertices));
}

/// A person of about 2,500 vertices.
inline ArticulatedBody person(int pose, int tessellation = 0) {
  return makeBody(bodyOptions(BodyKind::HUMAN, pose, tessellation));
}

}  // namespace posture::test
