// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

namespace posture {

// What attempts at one pair know of each other's answers, and what follows for their verdicts.

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

/// All of a surface, and what was measured on a part of it or with more to it.
ShapeSummary withMeasured(ShapeSummary whole, const ShapeSummary& compared);

}  // namespace posture
