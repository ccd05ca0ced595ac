// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/evaluation/target_metric.h>

#include <cstdint>
#include <vector>

namespace posture {

/// How far a map is from the truth. An error is the geodesic distance on the target from the place
/// found to the true vertex, divided by the square root of the target's area (Kim, Lipman and
/// Funkhouser 2011). A vertex without a counterpart has none.
struct MapErrors {
  int source_vertices = 0;
  int accepted = 0;                    ///< of source_vertices, with a counterpart
  int true_pairs = 0;                  ///< known pairs
  int mapped_pairs = 0;                ///< of these, with a counterpart
  std::vector<double> relative_error;  ///< of the mapped pairs that were measured
  std::vector<int> edge_error;         ///< of the same: edges from found to true vertex
};

/// Measures all mapped pairs. A wrong map on a large mesh would take minutes, as each front then
/// covers the mesh: when an evenly spread sample of 1,000 pairs foretells more than `work` settled
/// vertices, only as many pairs are measured, evenly spread again, as that work allows.
/// \throws std::invalid_argument  a pair or a place out of range.
MapErrors measureErrors(const TargetMetric& target,
                        const std::vector<SurfacePoint>& on_target,
                        const std::vector<VertexPair>& truth,
                        std::int64_t work = 100'000'000);

/// 0, 0.0025, ..., 0.25: where the error curve is sampled.
std::vector<double> curvePlaces();

/// For each of curvePlaces() the share of true pairs with at most that error. Pairs without a
/// counterpart count as never below, so the curve ends at the share mapped or lower.
std::vector<double> errorCurve(const MapErrors& errors);

/// The mean error over all true pairs, where one without a counterpart, or with a larger error,
/// counts as the end of the curve, 0.25: what the area above the curve comes to. Other than of the
/// mean of the mapped pairs, nothing is gained by leaving pairs out. NaN: there is no true pair.
double meanWithMisses(const MapErrors& errors);

/// How many of the measured pairs are 0, 1, 2, ... edges off.
std::vector<int> edgeHistogram(const MapErrors& errors);

/// Share of the measured pairs that are at most two edges off (NaN: none was measured), the figure
/// section 6.1 of the paper gives.
double shareWithinTwoEdges(const MapErrors& errors);

/// How one of several maps does on the same evenly spread pairs.
struct CandidateError {
  double mean = 0;          ///< relative error of the mapped pairs; NaN: none is mapped
  double share_mapped = 0;  ///< of the pairs looked at
};

/// Candidates are compared on at most `pairs` true pairs: some are turned or mirrored, and
/// measuring those costs a front over the whole mesh a pair. \param target_vertex  one vector a
/// candidate: source vertex -> target vertex, -1: rejected.
std::vector<CandidateError> candidateErrors(const TargetMetric& target,
                                            const std::vector<std::vector<int>>& target_vertex,
                                            const std::vector<VertexPair>& truth,
                                            int pairs = 1000);

/// The candidate of least mean error, among those that map at least a quarter as many of the pairs
/// as the one that maps most (a handful of lucky points is no map). -1: none maps anything.
int bestCandidate(const std::vector<CandidateError>& candidates);

/// Whether choosing `chosen` was a mistake, not a toss-up: its mean error is more than 1.5 times
/// that of `best` and more than 0.02 above it.
bool choseWrong(const CandidateError& chosen, const CandidateError& best);

/// A map against the left-right mirrored answer.
struct MirrorComparison {
  int pairs = 0;             ///< compared: mapped source vertices with a truth and a mirror truth
  double mean_to_truth = 0;  ///< relative errors; NaN where pairs is 0
  double mean_to_mirror = 0;
  double share_nearer_mirror = 0;  ///< of the pairs
  bool wrong_side = false;         ///< nearer to the mirrored answer than to the true one
};

/// On at most `pairs` evenly spread source vertices, as candidateErrors().
MirrorComparison compareWithMirror(const TargetMetric& target,
                                   const std::vector<SurfacePoint>& on_target,
                                   const std::vector<VertexPair>& truth,
                                   const std::vector<VertexPair>& mirror_truth,
                                   int pairs = 1000);

}  // namespace posture
