// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "stage_clock.h"
#include <functional>
#include <optional>
#include <vector>

namespace posture {

/// A registration as far as it takes to compare it with others: most of those made are not taken.
struct Attempt {
  /// Score, trust and the figures of its alternatives are as they will be; the map, of the main
  /// surface alone, is good to the edges of the work meshes, and the source is not deformed.
  RegistrationResult found;
  std::function<RegistrationResult()> finish;  ///< empty: `found` is all there is
};

/// \throws std::runtime_error  a surface cannot be bent (Arap)
RegistrationResult finished(Attempt attempt);

/// The attempt with what `change` makes of its result, before and after it is finished.
Attempt withChange(Attempt attempt, const std::function<void(RegistrationResult&)>& change);

/// Whether two attempts at one pair lead to the same places: what both map is at least half of what
/// either does, and lies less than a tenth of the size apart in the mean.
bool isSameAnswer(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target);

/// Whether `more` maps at least as much as `known`, but for crumbs, and leads to the same places
/// where both map.
bool goesOn(const RegistrationResult& known,
            const RegistrationResult& more,
            const TriangleMesh& target);

/// Whether two maps of one pair lead to the same places everywhere, but for crumbs;
/// not if they share less than half.
/// \param size  of the target: square root of its area.
bool agreeEverywhere(const std::vector<SurfacePoint>& x,
                     const std::vector<SurfacePoint>& y,
                     const TriangleMesh& target,
                     double size);

/// What an attempt pays for hands on the other side, by what another one with the same answer knows
/// as well: they may be cut off in the one and whole in the other. Only where that one has most
/// hands on the other side: a limb on the wrong side is its own.
double handsByBoth(const RegistrationResult& result,
                   const RegistrationResult& other,
                   const TriangleMesh& target);

/// Raises what is paid for hands, and what follows from that.
void payForHands(double hands, RegistrationResult& result);

/// For an answer found with a part of a side: how the map scores where it goes on over the whole
/// (MapScore::totalOfPiece()) counts, if that is worse, and all that was found with the part pays
/// for it. \param hands  what that score has for hands on the other side.
void payForExtending(double score, double hands, RegistrationResult& result);

/// Whether surface put in, patches or strips, leads an answer astray that was found without it too:
/// it then scores far worse, hands apart.
bool leadsAstray(const RegistrationResult& without, const RegistrationResult& with);

/// Whether an answer found with patches needs no second one that leads to the same places on the
/// surfaces as they are: it is all but certain, and not astray.
/// \param confirming_score  of the map that leads there, before it is refined.
bool knownStands(const RegistrationResult& known, double confirming_score);

/// One answer found twice: the better map, with the verdict that trusts it more. The map found with
/// closed holes drifts less, unless patches led it astray; but patches differ from pose to pose and
/// blur what tells answers apart, while long rims, as between few views of a body, hide that two
/// shapes are one.
/// \param verdict  its map does not matter.
RegistrationResult withMapOf(RegistrationResult verdict, RegistrationResult map);

/// The same answer over more of both sides, paid for, or with the rest of the source laid as it
/// goes; nothing: it stays as it is.
using Extension = std::function<std::optional<RegistrationResult>(const RegistrationResult&)>;

/// Of several attempts at one pair, on different parts of it, the one that scores best, the first
/// if none is better by more than scores vary, finished; one that cannot be is left out, unless
/// it is the last. The best of the others that leads elsewhere is named among its alternatives; if
/// the best one was extended and this is nearly as good, it is finished, and extended, too, and the
/// better one then wins. \pre  at least one.
/// \param extended  of what was found with a part of a side, which others may then agree with.
RegistrationResult bestAttempt(std::vector<Attempt> attempts,
                               const TriangleMesh& target,
                               const RegistrationOptions& options,
                               const Extension& extended,
                               StageClock& clock);

}  // namespace posture
