// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/synthesis/articulated_body.h>

#include <map>
#include <tuple>

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

/// Each is made once.
inline const ArticulatedBody& body(int pose,
                                   int vertices,
                                   int tessellation = 0,
                                   BodyKind kind = BodyKind::QUADRUPED) {
  static std::map<std::tuple<BodyKind, int, int, int>, ArticulatedBody> made;
  const auto [entry, is_new] = made.try_emplace({kind, pose, tessellation, vertices});
  if (is_new) entry->second = makeBody(bodyOptions(kind, pose, tessellation, vertices));
  return entry->second;
}

/// A person of about 2,500 vertices.
inline const ArticulatedBody& person(int pose, int tessellation = 0) {
  return body(pose, 2500, tessellation, BodyKind::HUMAN);
}

}  // namespace posture::test
