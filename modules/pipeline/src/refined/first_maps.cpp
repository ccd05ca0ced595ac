// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/first_maps.h"

#include <posture/core/parallel.h>
#include <posture/mesh/corners.h>

#include "refined/refinement/refined_pictures.h"
#include "refined/work/refined_shape.h"
#include "sides/pose.h"

namespace posture {
namespace {

/// How many maps between samples are bent onto the target.
constexpr int POOL = 32;

/// How many vertices a side counts as where the other one is reduced. The same for a side, its
/// parts and with its holes closed, so that scores of all can be compared, and however often the
/// file has a vertex.
int vertexCount(const GivenShape& given, const RefinedShape& shape) {
  return shape.parts.empty() ? cornerPlaces(given.input, given.ownVertices())
                             : static_cast<int>(shape.full.vertices.rows());
}

/// Evenly spread subsets of the vertices: all with all can be compared on them. A source much
/// coarser than the target gets more vertices first.
void reduceSides(PosedSide& source, PosedSide& target) {
  const TriangleMesh source_surface = posed(source.ordered.mesh, source.pose),
                     target_surface = posed(target.ordered.mesh, target.pose);
  source.shape = fullSide("source", source_surface, isMuchCoarser(source_surface, target_surface));
  target.shape = fullSide("target", target_surface, false);
  inParallel([&] { reduceSide("source", vertexCount(target.given, target.shape), source.shape); },
             [&] { reduceSide("target", vertexCount(source.given, source.shape), target.shape); });
}

}  // namespace

void FirstMaps::scale(double ratio) {
  chosen->source.scale(ratio);
  source_coarse = std::make_unique<SpectralSurface>(chosen->source.shape.coarseSurface());
  target_coarse = std::make_unique<SpectralSurface>(chosen->target.shape.coarseSurface());
}

FirstMaps preparedSides(const GivenShape& source_given,
                        const GivenShape& target_given,
                        StageClock& clock) {
  FirstMaps first(source_given, target_given);
  PosedSide &source = first.chosen->source, &target = first.chosen->target;
  clock.stage("reduction", 0.03, [&] { reduceSides(source, target); });

  // The smoothest functions on each surface, which do not change when it bends.
  clock.stage("spectrum", 0.09, [&] {
    inParallel([&] { addSpectrum("source", source.shape); },
               [&] { addSpectrum("target", target.shape); });
  });

  // Geodesic distances between samples, and their canonical forms (the paper's section 4.1).
  clock.stage("geodesic", 0.09, [&] {
    addSamples("source", source.shape);
    addSamples("target", target.shape);
  });
  clock.show([&] { return samplePictures(source.shape, target.shape); });
  return first;
}

FirstMaps firstMaps(const GivenShape& source_given,
                    const GivenShape& target_given,
                    StageClock& clock) {
  FirstMaps first = preparedSides(source_given, target_given, clock);
  const PosedSide &source = first.chosen->source, &target = first.chosen->target;

  // Maps between the samples: all axis orders and signs, and what the shapes' symmetries make of
  // them.
  const std::vector<SampleMap> pool = clock.stage("candidates", 0.08, [&] {
    return poolOfMaps(source.shape.samples, target.shape.samples, POOL);
  });

  // With holes the areas do not tell the scale, but distances under a map do; those under a
  // mirrored one as well.
  first.scale(distanceRatio(source.shape.samples, target.shape.samples, pool.front()));
  first.bent = bentFinalists(first.coarseSides(), pool, clock);
  return first;
}

}  // namespace posture
