// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <nlohmann/json.hpp>

#include "support/files.h"
#include "support/shapes.h"
#include <filesystem>
#include <string>

namespace posture::test {

/// Bent by an angle, and wider at one end, so that its ends differ: 147 vertices.
inline TriangleMesh taperedStrip(double angle) {
  TriangleMesh mesh = bentStrip(20, 6, 4, 1, angle);
  const TriangleMesh flat = bentStrip(20, 6, 4, 1, 0);
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    mesh.vertices(v, 1) *= 1 + 0.2 * flat.vertices(v, 0);
  return mesh;
}

/// Results of runs, a JSON file each, in the order the program writes.
struct StoredResults {
  std::filesystem::path folder;

  std::filesystem::path file(const std::string& run) const { return folder / (run + ".json"); }
  nlohmann::ordered_json operator()(const std::string& run) const {
    return nlohmann::ordered_json::parse(bytesOf(file(run)));
  }
  std::filesystem::file_time_type written(const std::string& run) const {
    return std::filesystem::last_write_time(file(run));
  }
};

}  // namespace posture::test
