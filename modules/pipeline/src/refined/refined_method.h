// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "answer/attempt.h"
#include "answer/known_answer.h"
#include "sides/given_shape.h"
#include "stage_clock.h"
#include <functional>
#include <limits>
#include <optional>

namespace posture {

/// An attempt with its first maps, before those are changed or refined.
struct BegunAttempt {
  /// The least of them: the farther below that of another attempt at the pair, the less that one is
  /// worth going on with. Infinite where none keeps the outside out.
  double score = std::numeric_limits<double>::infinity();

  /// Goes on with it, once. Nothing where the attempt is given up as the known answer stands.
  std::function<std::optional<Attempt>(const KnownAnswer& known)> goOn;
};

/// Beyond the paper: spectra and canonical forms give candidates, those that keep the outside out
/// are bent onto the target: so far the attempt is begun. Going on changes and refines the best;
/// finishing it takes the map to a fraction of an edge and completes the source. docs/pipeline.md
/// has the stages. The `input` of both sides and the clock outlive the attempt; `clean` need not.
BegunAttempt beginAttempt(const GivenShape& source,
                          const GivenShape& target,
                          const RegistrationOptions& options,
                          StageClock& clock);

/// Begun, and gone on with.
Attempt refinedMethod(const GivenShape& source,
                      const GivenShape& target,
                      const RegistrationOptions& options,
                      StageClock& clock);

/// An answer found with a part of a side, extended over both as far as they lie on each other. Its
/// score is MapScore::totalOfPiece() of that map, and what it pays for hands on the other side.
/// \param known  finished, in the numbering of both inputs.
/// \throws TornSurface  a surface cannot be bent; NoWayOn  the answer maps too little
Attempt extendedAnswer(const GivenShape& source,
                       const GivenShape& target,
                       const RegistrationResult& known,
                       const RegistrationOptions& options,
                       StageClock& clock);

}  // namespace posture
