// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/observer.h>

#include <filesystem>

namespace posture::app {

/// Writes the pictures of every stage into a folder as PLY files, numbered in the order they came:
/// 03-source-canonical-form.ply.
class StageDump {
 public:
  /// \throws InputError  the folder cannot be made.
  explicit StageDump(std::filesystem::path folder);

  void write(const StageEvent& event);

 private:
  std::filesystem::path folder_;
  int stages_ = 0;
};

}  // namespace posture::app
