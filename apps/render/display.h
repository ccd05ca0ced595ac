// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

namespace posture::render {

/// VTK draws through an X server even off screen. Uses the one that DISPLAY names; where there is
/// none, starts an Xvfb of its own, which ends with this object (or with the process).
class Display {
 public:
  /// \throws InputError  neither is to be had.
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

 private:
  pid_t server_ = -1;
};

}  // namespace posture::render
