// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace posture {

/// The value that cuts `values` into two classes of most variance between them (Otsu 1979), half
/// way between the neighbours of the cut; infinity for fewer than two values.
double otsuThreshold(std::vector<double> values);

}  // namespace posture
