// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/synthesis/articulated_body.h>
#include <posture/synthesis/simulated_scan.h>

#include "json_document.h"
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace posture::app {

/// One shape as it is asked for and as it came out.
struct SynthesizedShape {
  std::string name;
  BodyOptions options;
  ArticulatedBody body;
  std::optional<SimulatedScan> scan;

  std::string meshFile() const { return name + ".ply"; }
  std::string bonesFile() const { return name + "-bones.csv"; }
  std::string scanFile() const { return name + "-scan.pcd"; }
  std::string scanSurfaceFile() const { return name + "-scan-surface.txt"; }
};

/// Removes what a run before may have written of a shape of this name and this one does not write:
/// scans have no bones, and others no scan.
void removeOtherFilesOf(const std::filesystem::path& folder, const SynthesizedShape& shape);

/// Writes the shape, and with it its scan; returns what was written as JSON.
Json writeShape(const std::filesystem::path& folder, const SynthesizedShape& shape, bool quiet);

/// The bone of each vertex.
void writeBones(const std::filesystem::path& path, const ArticulatedBody& body);

/// How the bones move from the rest pose.
Json describeBones(const ArticulatedBody& body);

/// The pairs of shapes in a folder, for `pairs.csv`. Each writes its truth files and returns them
/// as JSON.
class PairList {
 public:
  /// Removes the list of a run before, whose meshes are about to be replaced.
  ///
  /// \param scans  whether there are any.
  PairList(std::filesystem::path folder, bool scans);

  Json add(const std::string& family,
           const SynthesizedShape& source,
           const SynthesizedShape& target);

  /// A body that holds still.
  Json addRigid(const std::string& family,
                const SynthesizedShape& source,
                const SynthesizedShape& target);

  /// The scans of the two.
  Json addScans(const std::string& family,
                const SynthesizedShape& source,
                const SynthesizedShape& target);

  void write() const;

 private:
  struct Surface {
    std::string mesh, vertices;
  };

  /// \param fields  id, family, kind, source, target.
  Json add(const std::vector<std::string>& fields,
           const std::vector<VertexPair>& truth,
           const std::vector<VertexPair>& mirror_truth,
           const std::string& note,
           const Surface& surface = {});

  std::filesystem::path folder_;
  bool scans_;
  std::string rows_;
};

}  // namespace posture::app
