// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace posture {

/// Text for the inside of an XML or HTML element or of a quoted attribute. Control characters,
/// which XML forbids, become blanks; bytes that are no UTF-8 become '?'.
std::string escapedMarkup(const std::string& text);

/// Coordinates and lengths: two decimals at most.
std::string coordinate(double value);

}  // namespace posture
