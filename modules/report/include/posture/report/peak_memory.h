// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace posture {

/// Largest resident memory of this process so far, in bytes; 0 where the system does not say.
long peakMemoryBytes();

/// The same in MiB.
double peakMemoryMib();

}  // namespace posture
