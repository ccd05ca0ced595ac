// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace posture::app {

inline const std::vector<std::string> MESH_ENDINGS = {".ply", ".obj", ".off"},
                                      CLOUD_ENDINGS = {".ply", ".pcd", ".xyz"};

/// What is wrong with the name of a file to be written; empty: nothing.
inline std::string wrongEnding(const std::filesystem::path& path,
                               const std::vector<std::string>& endings) {
  const std::string ending = CLI::detail::to_lower(path.extension().string());
  if (std::find(endings.begin(), endings.end(), ending) != endings.end()) return {};
  return path.string() + " ends in none of " + CLI::detail::join(endings, ", ");
}

/// So that a file that cannot be written is found before the work.
inline CLI::Validator endsInOneOf(const std::vector<std::string>& endings) {
  return CLI::Validator([endings](const std::string& name) { return wrongEnding(name, endings); },
                        "");
}

}  // namespace posture::app
