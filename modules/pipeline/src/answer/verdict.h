// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

namespace posture {

/// Mean consistency of distances under the chosen candidate of the paper's method, below which two
/// shapes are not taken for one body: docs/decisions/published.md has the measurements it lies
/// between.
constexpr double LEAST_CONSISTENCY = 0.855;

/// Sets the status from the chosen hypothesis: two bodies are called the same one when distances on
/// them agree under it.
void givePublishedVerdict(RegistrationResult& result);

/// The answer most likely next to the chosen one; -1: there is none.
int rivalOf(const RegistrationResult& result);

/// How likely another answer is beside the chosen one, by its margin; at most 1.
double likelihoodOf(const RegistrationResult& result, const AlternativeSummary& other);

/// So much trust is all but certain: what would only look for another answer is left out.
constexpr double ALL_BUT_CERTAIN = 0.9;

/// The score of a map where same and different bodies are equally likely:
/// docs/decisions/trust.md has the measurements.
constexpr double EVEN_SCORE = -8.7;

/// A map between coarse meshes that scores worse than another by more is hardly the right one.
constexpr double DECISIVE = 1;

/// How far the score of a map and its margin before the next different one speak for it, in [0, 1].
double trustIn(double score, double margin);
double trustIn(const RegistrationResult& result);

/// What a map pays, in its score, for tips of limbs under which its hands are on the other side.
/// \param right, wrong  how many tips speak for and against it.
double costOfHands(double right, double wrong);

/// Whether most hands that cost so much are on the other side: the body is turned then, and not a
/// limb laid on the other one.
bool mostHandsAreWrong(double cost);

/// Whether a map scores as those between poses of one body do.
bool convinces(double score);

/// Whether one of two maps between coarse meshes scores so much better that the other one, refined,
/// will hardly be the right one. Letting go of parts can make up for more.
bool isDecisive(double better, double worse);

/// Whether a map between coarse meshes may convince when it is changed or refined.
bool mayConvince(double score);

/// Whether the final map scores as those between poses of one body do.
bool looksAlike(const RegistrationResult& result);

/// Changes the trust, the confidences of all maps with it, and the status: registered where it is
/// enough to say that the answer is the right one.
void setTrust(double trust, RegistrationResult& result);

/// Takes another answer in among the alternatives, and the trust that costs.
/// \param rival_trust  that in which its confidences are.
void addRival(AlternativeSummary rival, double rival_trust, RegistrationResult& result);

/// For when every candidate turns the surface inside out or tears it: no counterparts, undecided.
/// \param source  its vertices as they came.
void leaveWhereItIs(const Points& source, RegistrationResult& result);

}  // namespace posture
