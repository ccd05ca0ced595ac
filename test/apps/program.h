// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/files.h"
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace posture::test {

/// What a program left behind.
struct ProgramRun {
  int exit_code = -1;  ///< 128 + signal where it was killed
  std::string out, err;
};

/// Runs `program` with these arguments and waits for it.
/// \param environment  NAME=value sets, NAME alone unsets.
ProgramRun run(const std::filesystem::path& program,
               const std::vector<std::string>& arguments,
               const std::vector<std::string>& environment = {});

/// Starts `program`, sends it the signal as soon as `when` holds, and waits for it.
ProgramRun runInterrupted(const std::filesystem::path& program,
                          const std::vector<std::string>& arguments,
                          int signal,
                          const std::function<bool()>& when);

/// That a failed program said why in one line on stderr and nothing on stdout.
bool saidWhyInOneLine(const ProgramRun& ended);

}  // namespace posture::test
