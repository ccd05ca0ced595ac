// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/settle.h>

#include <vector>

namespace posture {

/// The vertices of surface `a` that have no counterpart on `b`: those matched with the rim of a
/// hole, or let go of, that come to lie more than an edge from their match; those let go of that
/// come to lie, by chance, on what is the counterpart of another part of `a`; and, where the
/// surfaces were laid over each other, those around which `a`, bent, looks the other way than what
/// it lies on - a back laid on the inside of a front, where only that was seen.
///
/// \param laid  how the pair was found: by laying the surfaces over each other (layOver()).
std::vector<char> withoutPartner(const BendableSurface& a,
                                 const BendableSurface& b,
                                 const BentPair& pair,
                                 bool laid);

}  // namespace posture
