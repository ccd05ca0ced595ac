// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace posture {

/// A stage's result as a coloured mesh or cloud that one can look at.
struct StagePicture {
  std::string name;    ///< e.g. "source-canonical-form"
  TriangleMesh mesh;   ///< faces may be empty: a cloud
  Colors colors;       ///< n x 3, or 0 x 3
};

/// What a run says while it goes on.
struct StageEvent {
  std::string_view stage;  ///< "geodesic", "embedding", ...
  double progress = 0;     ///< of the whole run, in [0, 1]
  /// Makes this stage's pictures; empty at the start of a stage. Called by those who want them.
  std::function<std::vector<StagePicture>()> pictures;
};

/// Called from the thread that called registerShapes(); an exception it throws ends the run.
using Observer = std::function<void(const StageEvent&)>;

}  // namespace posture
