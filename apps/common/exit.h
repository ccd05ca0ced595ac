// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>

namespace posture::app {

/// Exit codes of all programs.
inline constexpr int EXIT_UNDECIDED = 1;
inline constexpr int EXIT_USAGE = 2;
inline constexpr int EXIT_INPUT = 3;

/// One line on stderr, whatever line breaks the message has; returns the exit code.
inline int fail(const char* program, const char* message, int exit_code) noexcept {
  std::fprintf(stderr, "%s: ", program);
  for (const char* c = message; *c != '\0'; ++c)
    std::fputc(*c == '\n' || *c == '\r' ? ' ' : *c, stderr);
  std::fputc('\n', stderr);
  return exit_code;
}

}  // namespace posture::app
