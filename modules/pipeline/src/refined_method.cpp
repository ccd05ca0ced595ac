// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined_method.h"

#include <posture/core/parallel.h>
#include <posture/mesh/edges.h>
#include <posture/refine/tip_maps.h>

#include "answers.h"
#include "finalists.h"
#include "loose_pieces.h"
#include "pose.h"
#include "refined_maps.h"
#include "refined_pictures.h"
#include "refined_result.h"
#include "refined_shape.h"
#include "verdict.h"
#include "way_back.h"
#include "whole_source.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace posture {
namespace {

constexpr int POOL = 32, MOST_TIP_MAPS = 8;
constexpr std::size_t MOST_ALTERNATIVES = 4;

AlternativeSummary summarize(const Finalist& finalist) {
  AlternativeSummary summary;
  summary.orientation = finalist.orientation;
  summary.bending = finalist.score.bending;
  summary.curvature = finalist.score.curvature;
  summary.distortion = finalist.score.distortion;
  summary.return_miss = finalist.score.return_miss;
  summary.score = finalist.score.total();
  return summary;
}

ShapeSummary summarize(const GivenShape& given, const RefinedShape& shape) {
  ShapeSummary summary = summarize(given);
  summary.added_vertices = static_cast<int>(shape.full.vertices.rows()) - summary.clean_vertices;
  summary.samples = static_cast<int>(shape.samples.form.rows());
  summary.stress = shape.stress;
  return summary;
}

/// The answer that the final map is a refinement of.
int nearestAnswer(const std::vector<AlternativeSummary>& alternatives) {
  const auto nearest = std::min_element(alternatives.begin(),
                                        alternatives.end(),
                                        [](const auto& a, const auto& b) { return a.gap < b.gap; });
  return static_cast<int>(nearest - alternatives.begin());
}

/// The same for a side, its parts and with its holes closed, so that scores of all can be compared.
int vertexCount(const GivenShape& given, const RefinedShape& shape) {
  return shape.parts.empty() ? given.ownVertices() : static_cast<int>(shape.full.vertices.rows());
}

double rootArea(const GivenShape& shape) { return std::sqrt(faceAreas(shape.clean.mesh).sum()); }

}  // namespace

RegistrationResult refinedMethod(const GivenShape& source_cleaned,
                                 const GivenShape& target_cleaned,
                                 const RegistrationOptions& options,
                                 StageClock& clock) {
  // Lengths in square roots of the target's area: the k-th eigenvalue is then near 4 pi k.
  // Each shape in a frame and an order of its own: the answer does not depend on those it came in.
  Pose source_pose = poseOf(source_cleaned.clean.mesh, 1 / rootArea(source_cleaned));
  const Pose target_pose = poseOf(target_cleaned.clean.mesh, 1 / rootArea(target_cleaned));
  const CleanMesh source_ordered = inOrder(source_cleaned.clean, source_pose);
  const CleanMesh target_ordered = inOrder(target_cleaned.clean, target_pose);
  const GivenShape source_given{
      source_cleaned.input, source_ordered, source_cleaned.patch_vertices};
  const GivenShape target_given{
      target_cleaned.input, target_ordered, target_cleaned.patch_vertices};
  const TriangleMesh source_surface = posed(source_ordered.mesh, source_pose),
                     target_surface = posed(target_ordered.mesh, target_pose);
  RefinedShape source, target;

  // Evenly spread subsets of the vertices: all with all can be compared on them. A source much
  // coarser than the target gets more vertices first.
  clock.stage("reduction", 0.03, [&] {
    source = fullSide("source", source_surface, isMuchCoarser(source_surface, target_surface));
    target = fullSide("target", target_surface, false);
    parallelFor(2, [&](int side) {
      if (side == 0) reduceSide(vertexCount(target_given, target), source);
      if (side == 1) reduceSide(vertexCount(source_given, source), target);
    });
  });

  // The smoothest functions on each surface, which do not change when it bends.
  clock.stage("spectrum", 0.09, [&] {
    parallelFor(2, [&](int side) { addSpectrum(side == 0 ? source : target); });
  });

  // Geodesic distances between samples, and their canonical forms (the paper's section 4.1).
  clock.stage("geodesic", 0.09, [&] {
    addSamples(source);
    addSamples(target);
  });
  clock.show([&] { return samplePictures(source, target); });

  // Maps between the samples: all axis orders and signs, and what the shapes' symmetries make of
  // them.
  const std::vector<SampleMap> pool = clock.stage(
      "candidates", 0.08, [&] { return poolOfMaps(source.samples, target.samples, POOL); });

  // With holes the areas do not tell the scale, but distances under a map do; those under a
  // mirrored one as well.
  const double ratio = distanceRatio(source.samples, target.samples, pool.front());
  source = rescaled(std::move(source), ratio);
  source_pose.unit *= ratio;

  // Those that keep the outside out, bent onto the target; the least strained first.
  const SpectralSurface source_coarse = source.coarseSurface(),
                        target_coarse = target.coarseSurface();
  std::vector<Finalist> finalists = clock.stage("bending", 0.1, [&] {
    std::vector<Finalist> registered =
        registerFinalists(source_coarse, target_coarse, source.samples, target.samples, pool);
    exchangeParts(source_coarse, target_coarse, 2 * target.samples.spacing, registered);
    return registered;
  });

  // Where bodies stretch, the right candidate is not among those that change distances least.
  if (finalists.empty() || !convinces(finalists.front().score.total()))
    clock.stage("tips", 0.05, [&] {
      const std::vector<SampleMap> tip_maps =
          tipMaps(source.samples, target.samples, MOST_TIP_MAPS);
      finalists =
          joined(std::move(finalists),
                 registerFinalists(
                     source_coarse, target_coarse, source.samples, target.samples, tip_maps));
      bendFurther(source_coarse, target_coarse, finalists);
    });

  // Spectra and scale go astray where much is missing; surfaces laid over each other do not.
  if (finalists.empty() || !convinces(finalists.front().score.total()))
    finalists = clock.stage("laying over", 0.05, [&] {
      const auto places =
          [](const SpectralSurface& surface, const CleanMesh& clean, const Pose& pose) {
            return SurfacePlaces(withPieces(surface.mesh, posed(clean.pieces, pose)));
          };
      return joined(std::move(finalists),
                    layFinalists(source_coarse,
                                 target_coarse,
                                 places(source_coarse, source_ordered, source_pose),
                                 places(target_coarse, target_ordered, target_pose)));
    });
  RegistrationResult result;
  result.source = summarize(source_given, source);
  result.target = summarize(target_given, target);
  if (finalists.empty()) {
    result.scale = source_pose.unit / target_pose.unit;
    giveVerdictWithoutFinalist(source_given, result);
    return result;
  }
  const double gap = 2 * target.samples.spacing;
  const std::vector<int> distinct = distinctFinalists(finalists, target_coarse.mesh, gap);
  clock.show([&] { return finalistPictures(source_coarse, target_coarse, finalists, distinct); });

  // The leading ones, as precise as the work meshes allow; the best wins.
  const std::vector<RefinedMap> refined = clock.stage("refinement", 0.27, [&] {
    const std::vector<int> leading = leadingOf(finalists, distinct);
    std::vector<const Finalist*> chosen;
    for (int i : leading) chosen.push_back(&finalists[i]);
    std::vector<RefinedMap> maps = refineFinalists(source, target, chosen);
    for (RefinedMap& map : maps) map.finalist = leading[map.finalist];
    return maps;
  });
  const RefinedMap& best = refined.front();
  const RefinedAnswers refined_answers(
      refined, finalists, distinct, target_coarse.mesh, target.work.mesh, gap);
  const std::vector<int> answers = foremost(
      refined_answers.remaining(), finalists, target_coarse.mesh, best.finalist, MOST_ALTERNATIVES);
  source_pose.unit *= best.scale;
  result.scale = source_pose.unit / target_pose.unit;
  clock.show([&] { return refinedPictures(source, target, best); });

  // All vertices, to a fraction of an edge.
  const FullMap full = clock.stage("full resolution", 0.05, [&] {
    const VertexMaps& winner = finalists[best.finalist].maps;
    for (int i : answers) {
      AlternativeSummary summary = summarize(finalists[i]);
      if (const RefinedMap* map = refined_answers.of(i)) summary.refined_score = map->score.total();
      summary.gap = gapBetween(target_coarse.mesh, winner, finalists[i].maps);
      summary.target_vertex =
          coarseToInput(finalists[i].maps, source_given, source, target_given, target);
      result.alternatives.push_back(std::move(summary));
    }
    result.chosen = nearestAnswer(result.alternatives);
    result.score = best.score.total();
    result.alternatives[result.chosen].refined_score = result.score;
    result.trust = trustIn(result);
    FullMap map = toFullResolution(source, target, best);
    result.correspondence =
        correspondenceOf(source_given, source, target_given, target, map, result.trust);
    return map;
  });

  // Every vertex of the source a place, as isometric as the target allows (section 6.2).
  clock.stage("completion", 0.1, [&] {
    const TriangleMesh scaled = rescaled(source, best.scale).full;
    const std::vector<char> known(full.places.size(), 1);
    result.deformed =
        target_pose.outOf(placesOfInput(source_given,
                                        scaled,
                                        known,
                                        placesOfWhole(scaled, target.full, full),
                                        source_pose.into(source_given.input.vertices)));
    placeLoosePieces(source_given, target_given, result);
    giveVerdict(result);
  });
  if (options.both_ways)
    clock.stage("way back", 0.0, [&] {
      result.back = wayBack({source_given, rescaled(source, best.scale), source_pose},
                            {target_given, target, target_pose},
                            full,
                            result);
    });
  if (options.refine_alternatives)
    clock.stage("alternatives", 0.0, [&] {
      for (std::size_t k = 0; k < result.alternatives.size(); ++k) {
        if (static_cast<int>(k) == result.chosen) continue;
        AlternativeSummary& other = result.alternatives[k];
        const double likelihood = std::exp(std::min(0.0, -marginBefore(result, other)));
        const RefinedMap* known = refined_answers.of(answers[k]);
        const RefinedMap map =
            known != nullptr ? *known
                             : refineFinalists(source, target, {&finalists[answers[k]]}).front();
        other.correspondence = correspondenceOf(source_given,
                                                source,
                                                target_given,
                                                target,
                                                toFullResolution(source, target, map),
                                                result.trust * likelihood);
      }
    });
  return result;
}

}  // namespace posture
