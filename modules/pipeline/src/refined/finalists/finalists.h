// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>
#include <posture/refine/lay_over.h>
#include <posture/refine/map_score.h>
#include <posture/refine/sample_maps.h>
#include <posture/refine/surface.h>

#include <optional>
#include <vector>

namespace posture {

/// The most functions that finalists are bent with.
constexpr int FINALIST_BASIS = 60;

/// Of the orientation of a finalist: right candidates have 0.38 and more, mirrored ones -0.35 and
/// less; between them are maps that are torn, which are no use either.
constexpr double LEAST_ORIENTATION = 0.2;

/// A candidate that keeps the outside out, registered on the coarse meshes.
struct Finalist {
  double orientation = 0;  ///< of the map it began as; if that was changed since, of what it became
  VertexMaps maps;         ///< between the coarse meshes
  MapScore score;
  double scale = 1;              ///< what the source was multiplied by for it
  std::optional<BentPair> bent;  ///< the coarse meshes, the source scaled; if laid anew
  bool laid = false;             ///< the surfaces were laid over each other
};

/// Those of the sample maps that do not turn the surface inside out, each registered from a low
/// and from a high start; by increasing score.
std::vector<Finalist> registerFinalists(const SpectralSurface& source,
                                        const SpectralSurface& target,
                                        const SampledShape& source_samples,
                                        const SampledShape& target_samples,
                                        const std::vector<SampleMap>& pool);

/// Bends the best finalists on, from where they are, a few times as long as that makes their scores
/// better: pairs far from isometric need several ways down. Leaves all by increasing score.
void bendFurther(const SpectralSurface& source,
                 const SpectralSurface& target,
                 std::vector<Finalist>& finalists);

/// Finalists of another kind: the coarse surfaces laid over each other as they are, then bent. They
/// ask for poses that are not too different, but not for whole surfaces. By increasing score.
/// \param source_places, target_places  on all pieces of each, the surface among them.
std::vector<Finalist> layFinalists(const SpectralSurface& source,
                                   const SpectralSurface& target,
                                   const SurfacePlaces& source_places,
                                   const SurfacePlaces& target_places);

/// Puts two lists into one, by increasing score.
std::vector<Finalist> joined(std::vector<Finalist> some, std::vector<Finalist> others);

/// Where another finalist differs from the best one in a part of the body only - a limb turned the
/// wrong way round - takes that part from it if the whole then scores better. Does so until
/// nothing gets better; the improved finalist comes first, before the one it was made of, whose
/// orientation it keeps.
/// \param gap  how far apart two places are not the same any more, in working units.
void exchangeParts(const SpectralSurface& source,
                   const SpectralSurface& target,
                   double gap,
                   std::vector<Finalist>& finalists);

}  // namespace posture
