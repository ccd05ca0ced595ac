// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "common/exit.h"

namespace posture::app {

/// What every verb takes and gives back.
struct Common {
  bool quiet = false;  ///< nothing on stderr but errors
  bool json = false;   ///< results on stdout as JSON
  int threads = 0;     ///< 0: as many as there are processors
  unsigned long seed = 1;
  int exit_code = 0;
};

/// Each adds its verb to `app`; the verb's callback does the work and sets common.exit_code.
void addRegister(CLI::App& app, Common& common);
void addApply(CLI::App& app, Common& common);
void addReconstruct(CLI::App& app, Common& common);
void addSegment(CLI::App& app, Common& common);
void addEvaluate(CLI::App& app, Common& common);
void addBenchmark(CLI::App& app, Common& common);
void addCompare(CLI::App& app, Common& common);
void addSynthesize(CLI::App& app, Common& common);
void addRender(CLI::App& app, Common& common);

}  // namespace posture::app
