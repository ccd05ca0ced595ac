// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Outliers of a mesh: vertices that lie far from all their neighbours, most of which lie close
/// together and have short edges elsewhere.
/// They are moved to the middle of these, those that are spikes themselves left out; vertices at
/// the same place move together. A thin tip that a single vertex makes, more than five times as
/// long as its half width, counts as one. \return  how many places were set back; one whose
/// neighbours are all spikes stays.
int setSpikesBack(TriangleMesh& mesh);

}  // namespace posture
