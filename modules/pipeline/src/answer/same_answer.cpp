// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer/same_answer.h"

#include <posture/mesh/position_of.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace posture {
namespace {

/// Answers that are closer in the mean, in square roots of the target's area, are one: about the
/// distance between samples.
constexpr double SAME_ANSWER = 0.1;

/// A hand, the least part that is a matter of its own, is a fiftieth of a body.
constexpr double A_PART = 0.02;

}  // namespace

Overlap overlapOf(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target,
                  double size) {
  const std::vector<SurfacePoint>&a = x.correspondence.on_target, &b = y.correspondence.on_target;
  Overlap overlap;
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    overlap.either += a[v].vertex >= 0 || b[v].vertex >= 0;
    if (a[v].vertex < 0 || b[v].vertex < 0) continue;
    ++overlap.both;
    sum += (positionOf(target, a[v]) - positionOf(target, b[v])).norm();
  }
  overlap.fewer = static_cast<int>(std::min(mappedCount(a), mappedCount(b)));
  if (overlap.both > 0) overlap.gap = sum / (overlap.both * size);
  return overlap;
}

double gapOf(const Overlap& overlap) {
  return overlap.both == 0 || 2 * overlap.both < overlap.fewer ? 1 : overlap.gap;
}

bool leadsElsewhere(const Overlap& overlap) { return gapOf(overlap) >= SAME_ANSWER; }

bool isSameAnswer(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target) {
  const Overlap overlap = overlapOf(x, y, target, std::sqrt(x.target.area));
  return overlap.both > 0 && 2 * overlap.both >= overlap.either && overlap.gap < SAME_ANSWER;
}

bool goesOn(const RegistrationResult& known,
            const RegistrationResult& more,
            const TriangleMesh& target) {
  const auto before = static_cast<double>(mappedCount(known.correspondence.on_target)),
             after = static_cast<double>(mappedCount(more.correspondence.on_target));
  return after >= (1 - A_PART) * before &&
         !leadsElsewhere(overlapOf(known, more, target, std::sqrt(known.target.area)));
}

bool agreeEverywhere(const std::vector<SurfacePoint>& x,
                     const std::vector<SurfacePoint>& y,
                     const TriangleMesh& target,
                     double size) {
  int both = 0, either = 0, elsewhere = 0;
  for (std::size_t v = 0; v < x.size(); ++v) {
    either += x[v].vertex >= 0 || y[v].vertex >= 0;
    if (x[v].vertex < 0 || y[v].vertex < 0) continue;
    ++both;
    elsewhere += (positionOf(target, x[v]) - positionOf(target, y[v])).norm() > SAME_ANSWER * size;
  }
  return both > 0 && 2 * both >= either && elsewhere < A_PART * both;
}

}  // namespace posture
