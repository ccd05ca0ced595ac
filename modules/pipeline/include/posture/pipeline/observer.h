// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace posture {

/// A stage's result as a mesh or cloud that one can look at.
struct StagePicture {
  std::string name;   ///< "source-canonical-form"
  TriangleMesh mesh;  ///< faces may be empty: a cloud
  /// n x 3, or 0 x 3: the place of each vertex on a surface. Equal places get equal colours.
  Points place;
  /// n, or 0: a number for each vertex, to be shown as a colour. Used when `place` is empty.
  Vector value;
};

/// What a run says while it goes on.
struct StageEvent {
  std::string_view attempt;  ///< "": as given; "parted", "patched", "piece-1", ...
  std::string_view stage;    ///< "geodesic", "embedding", ...
  double progress = 0;       ///< of the whole run, in [0, 1]
  /// Makes the pictures of the stage that has just ended; empty when one begins. Only those who
  /// want pictures pay for them.
  std::function<std::vector<StagePicture>()> pictures;
};

/// An attempt and a stage of it in one: "parted geodesic", or "geodesic" of the surfaces as given.
std::string stageTitle(std::string_view attempt, std::string_view stage);

/// Called from the thread that called registerShapes(); an exception it throws ends the run.
using Observer = std::function<void(const StageEvent&)>;

}  // namespace posture
