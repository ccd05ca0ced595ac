// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>

#include <vector>

namespace posture {

/// What a pair was found by that tells who has no counterpart.
struct HowFound {
  bool laid = false;      ///< by laying the surfaces over each other (layOver())
  bool may_lack = false;  ///< as surfaces of which one may lack a part of the other
};

/// The vertices of surface `a` that have no counterpart on `b`: those matched with the rim of a
/// hole, or let go of, that come to lie more than an edge from their match; where a part may be
/// missing, those on what is the counterpart of another part of `a` - a forearm that lies along a
/// hip, for want of its own place; and, where the surfaces were laid over each other, those around
/// which `a`, bent, looks the other way than what it lies on - a back laid on the inside of a
/// front, where only that was seen.
std::vector<char> withoutPartner(const BendableSurface& a,
                                 const BendableSurface& b,
                                 const BentPair& pair,
                                 const HowFound& found);

}  // namespace posture
