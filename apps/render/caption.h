// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"
#include <string>

namespace posture::render {

/// One line of dark grey text on white, no wider than `width`: too long a text loses its middle.
/// \param size  height of the letters in points at 72 dpi.
Image caption(const std::string& text, int size, int width);

}  // namespace posture::render
