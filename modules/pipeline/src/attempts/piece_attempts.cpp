// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts/piece_attempts.h"

#include "answer/same_answer.h"
#include "answer/shared_verdict.h"
#include "answer/verdict.h"
#include "refined/completion/whole_source.h"
#include "refined/refined_method.h"
#include "sides/parts_like.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Parts of a whole that a piece is compared with, in all.
constexpr int MOST_PARTS = 4;

/// First maps with a part that are behind a convincing answer by more are not gone on with: of
/// those seen none came within 0.8 of it (decisions/attempts.md).
constexpr double FAR_BEHIND = 2.5;

/// What an answer that does not go on over the whole counts as: it can hardly be right.
constexpr double NO_WAY_ON = EVEN_SCORE + DECISIVE;

/// What was found on a part of a surface, and all of it otherwise. \param rest  restOf() the part.
ShapeSummary withPart(const ShapeSummary& whole,
                      const ShapeSummary& part,
                      const std::vector<char>& rest) {
  ShapeSummary summary = withMeasured(whole, part);
  // Areas of one surface are summed in different orders.
  const bool is_all = std::find(rest.begin(), rest.end(), 1) == rest.end();
  summary.compared_share = is_all ? 1 : part.area / whole.area;
  return summary;
}

/// The main surfaces of both sides, one of them with a part alone.
struct PartPair {
  CleanMesh source, target;
};

std::vector<PartPair> partPairs(const GivenShape& source, const GivenShape& target) {
  std::vector<PartPair> found;
  const bool source_may = mayBePiece(source.clean), target_may = mayBePiece(target.clean);
  const int most = source_may && target_may ? MOST_PARTS / 2 : MOST_PARTS;
  if (source_may)
    for (CleanMesh& part : partsLike(source.clean, target, most))
      found.push_back({source.clean, std::move(part)});
  if (target_may)
    for (CleanMesh& part : partsLike(target.clean, source, most))
      found.push_back({std::move(part), target.clean});
  return found;
}

/// Of each vertex of the input whether it is of the main surface but not of the part: to the
/// attempt it is loose.
std::vector<char> restOf(const CleanMesh& whole, const CleanMesh& part) {
  std::vector<char> rest(static_cast<std::size_t>(whole.offset.size()), 0);
  for (Eigen::Index v = 0; v < whole.offset.size(); ++v)
    rest[static_cast<std::size_t>(v)] = !part.isOnMain(v) && whole.isOnMain(v);
  return rest;
}

/// An attempt with a part of a side, begun.
struct PieceAttempt {
  BegunAttempt begun;
  std::vector<char> source_rest, target_rest;
};

/// The result in the figures of the whole. What corresponds to the rest of a side is not known.
Attempt ofWhole(Attempt attempt,
                const ShapeSummary& source,
                const ShapeSummary& target,
                const PieceAttempt& piece) {
  return withChange(
      std::move(attempt),
      [source, target, source_rest = piece.source_rest, target_rest = piece.target_rest](
          RegistrationResult& result) {
        result.source = withPart(source, result.source, source_rest);
        result.target = withPart(target, result.target, target_rest);
        dropRows(source_rest, target_rest, result.correspondence);
        for (AlternativeSummary& other : result.alternatives)
          for (std::size_t v = 0; v < other.target_vertex.size(); ++v)
            if (source_rest[v] != 0) other.target_vertex[v] = -1;
        if (result.back) dropRows(target_rest, source_rest, result.back->correspondence);
      });
}

}  // namespace

void addPieceAttempts(const GivenShape& source,
                      const GivenShape& target,
                      const RegistrationOptions& options,
                      StageClock& clock,
                      std::vector<Attempt>& attempts) {
  const std::optional<std::vector<PartPair>> found = clock.tryTo(
      [&] { return clock.stage("pieces", 0, [&] { return partPairs(source, target); }); });
  if (!found) return;
  const std::vector<PartPair>& pairs = *found;
  std::vector<PieceAttempt> pieces;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [a, b] = pairs[i];
    std::optional<BegunAttempt> begun =
        clock.tryAttempt("piece-" + std::to_string(i + 1), 0, [&, &a = a, &b = b] {
          return beginAttempt({source.input, a}, {target.input, b}, options, clock);
        });
    if (begun)
      pieces.push_back({std::move(*begun), restOf(source.clean, a), restOf(target.clean, b)});
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const PieceAttempt& x, const PieceAttempt& y) {
    return x.begun.score < y.begun.score;
  });
  const ShapeSummary of_source = attempts.front().found.source,
                     of_target = attempts.front().found.target;
  double worst = std::numeric_limits<double>::infinity();
  for (const Attempt& attempt : attempts)
    if (looksAlike(attempt.found)) worst = std::min(worst, attempt.found.score + FAR_BEHIND);
  std::optional<double> convincing;
  for (const PieceAttempt& piece : pieces) {
    if (piece.begun.score > worst || (convincing && isDecisive(*convincing, piece.begun.score)))
      break;
    std::optional<Attempt> attempt = clock.tryTo([&] { return *piece.begun.goOn({}); });
    if (!attempt) continue;
    if (!convincing && looksAlike(attempt->found)) convincing = piece.begun.score;
    attempts.push_back(ofWhole(std::move(*attempt), of_source, of_target, piece));
  }
}

std::optional<RegistrationResult> extendedToWhole(const GivenShape& source,
                                                  const GivenShape& target,
                                                  RegistrationResult known,
                                                  const RegistrationOptions& options,
                                                  StageClock& clock) {
  if (!isOfPart(known)) return {};
  std::optional<RegistrationResult> whole = clock.tryAttempt("extended", 0, [&] {
    return finished(extendedAnswer(source, target, known, options, clock));
  });
  if (whole && whole->chosen >= 0 && std::isfinite(whole->score) &&
      goesOn(known, *whole, target.input)) {
    payForExtending(whole->score, whole->hands, known);
    setTrust(known.trust, *whole);
    return withMapOf(std::move(known), std::move(*whole));
  }
  payForExtending(NO_WAY_ON, 0, known);
  if (known.source.compared_share < 1)
    if (auto laid = clock.tryTo([&] { return restLaid(source, known); }))
      known.deformed = std::move(*laid);
  return known;
}

}  // namespace posture
