// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/observer.h>

#include "folder.h"
#include <filesystem>
#include <string>
#include <vector>

namespace posture::app {

/// Writes the pictures of every stage into a folder as PLY files, numbered in the order they came:
/// 03-source-canonical-form.ply. stages.txt lists them: those of a run before are removed first.
class StageDump {
 public:
  /// \throws InputError  the folder cannot be made, or an input is one of the files in it that are
  /// written over.
  StageDump(std::filesystem::path folder, const std::vector<std::filesystem::path>& inputs);

  void write(const StageEvent& event);

 private:
  std::filesystem::path folder_;
  OutputFolder output_;
  std::string list_;  ///< of the files so far, a line each
  int stages_ = 0;
};

}  // namespace posture::app
