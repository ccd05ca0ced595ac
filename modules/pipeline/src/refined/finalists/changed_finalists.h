// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/finalists/finalists.h"
#include <vector>

namespace posture {

// Where parts of a body are missing, the right map may not be among those that candidates lead to.
// Finalists are changed here so that it comes of one that is right on some of it, or of the other
// answer that the body's symmetry has.

/// Finalists, and the first different ones of them once more with what they misplace let go of,
/// where that makes their scores better, and what is left looks like one body (convinces()) and
/// keeps the outside out. By increasing score.
/// \param distinct  of the finalists, those that are different.
std::vector<Finalist> withPartsLetGo(const SpectralSurface& source,
                                     const SpectralSurface& target,
                                     const std::vector<int>& distinct,
                                     std::vector<Finalist> finalists);

/// Finalists, and the best of what comes of keeping a part of the first different ones that may
/// convince and laying the rest anew (growAnew()), where that scores better than what it came of
/// and than any that is the same answer, looks like one body and keeps the outside out. By
/// increasing score.
///
/// \param distinct  of the finalists, those that are different, by more than `gap`.
std::vector<Finalist> withPartsGrownAnew(const SpectralSurface& source,
                                         const SpectralSurface& target,
                                         const std::vector<int>& distinct,
                                         double gap,
                                         std::vector<Finalist> finalists);

/// Maps of a surface onto itself that move it and keep the outside out, on the coarse mesh: a
/// person turned by half about the axis, front to back. The best first.
std::vector<VertexMaps> turnsOntoItself(const SpectralSurface& surface,
                                        const SampledShape& samples);

/// Of each surface onto itself, see turnsOntoItself().
struct Turns {
  std::vector<VertexMaps> source, target;
};

/// Finalists, and the best of what comes of following the first different ones by a turn of either
/// side, where that scores better than any of them that is the same answer, looks like one body and
/// keeps the outside out. By increasing score.
/// \param distinct  of the finalists, those that are different, by more than `gap`.
std::vector<Finalist> withTurned(const SpectralSurface& source,
                                 const SpectralSurface& target,
                                 const Turns& turns,
                                 const std::vector<int>& distinct,
                                 double gap,
                                 std::vector<Finalist> finalists);

}  // namespace posture
