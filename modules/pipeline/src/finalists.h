// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/map_score.h>
#include <posture/refine/sample_maps.h>
#include <posture/refine/settle.h>
#include <posture/refine/surface.h>

#include <vector>

namespace posture {

/// A candidate that keeps the outside out, registered on the coarse meshes.
struct Finalist {
  double distortion = 0;   ///< of the sample map it comes from
  double orientation = 0;  ///< of that map
  VertexMaps maps;         ///< between the coarse meshes
  MapScore score;
};

/// Those of the sample maps that do not turn the surface inside out, each registered from a low
/// and from a high start; by increasing score.
std::vector<Finalist> registerFinalists(const SpectralSurface& source,
                                        const SpectralSurface& target,
                                        const SampledShape& source_samples,
                                        const SampledShape& target_samples,
                                        const std::vector<SampleMap>& pool);

/// Where another finalist differs from the best one in a part of the body only - a limb turned the
/// wrong way round - takes that part from it if the whole then scores better. Does so until
/// nothing gets better; the improved finalist comes first, before the one it was made of.
/// \param gap  how far apart two places are not the same any more, in mesh units.
void exchangeParts(const SpectralSurface& source,
                   const SpectralSurface& target,
                   double gap,
                   std::vector<Finalist>& finalists);

/// Mean distance on the target between where two maps of the coarse meshes take the source's
/// vertices, straight: no unit, as the body's area is about one.
double gapBetween(const SpectralSurface& target, const VertexMaps& x, const VertexMaps& y);

/// Of finalists by increasing score, the first and those that differ from every better one by more
/// than `gap`.
std::vector<int> distinctFinalists(const std::vector<Finalist>& finalists,
                                   const SpectralSurface& target,
                                   double gap);

/// A map between the work meshes with what speaks against it.
struct RefinedMap {
  int finalist = 0;  ///< index of the one it was made of
  BentPair pair;
  MapScore score;
};

/// Takes finalists to the work meshes and makes them as exact as those allow; by increasing score.
std::vector<RefinedMap> refineFinalists(const SpectralSurface& coarse_source,
                                        const SpectralSurface& coarse_target,
                                        const SpectralSurface& source,
                                        const SpectralSurface& target,
                                        const std::vector<const Finalist*>& finalists);

/// How soft surfaces are when they settle, on any resolution: as the largest basis is fine.
double settlingSoftness(const SpectralSurface& source, const SpectralSurface& target);

}  // namespace posture
