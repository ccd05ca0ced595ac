// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/scan/reconstruct.h>

#include "points/orientation.h"
#include "points/oriented_points.h"

namespace posture {

/// Points that belong to the scan, and what is known of them.
struct ScanPoints {
  Points points;  ///< in the working frame
  OutsideHints hints;
};

/// Leaves out outliers: `kept` has the rows that stay. Averages neighbours where noise hides the
/// surface. Lengths in the summary are in the working frame.
/// \throws InputError  nothing stays, or all of it on one line.
ScanPoints filterPoints(const ScanPoints& given,
                        std::vector<int>& kept,
                        ReconstructionSummary& summary);

/// Smooth, oriented points, spread evenly.
OrientedPoints sampleSurface(const ScanPoints& scan,
                             SurfaceMethod method,
                             ReconstructionSummary& summary);

}  // namespace posture
