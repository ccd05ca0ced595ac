// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/point_cloud.h>
#include <posture/evaluation/target_metric.h>
#include <posture/scan/reconstruct.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace posture::app {

/// The mesh on which errors are measured, and where the target's vertices (points) lie on it.
class TargetPlaces {
 public:
  /// A mesh is measured on itself, a cloud on the surface laid through it.
  /// \param path  of the target, for messages
  /// \param scan  of the target where it is a cloud; laid through it here if there is none.
  /// \throws InputError  no surface can be laid through it.
  TargetPlaces(const std::filesystem::path& path,
               const Shape& target,
               const std::optional<ScanSurface>& scan);

  /// Measured on `surface`, a clean mesh of the same body in the same frame.
  /// \param vertices  file of rows: a vertex (point) of the target, a vertex of the surface.
  /// Others, or all where it is empty, go to the nearest one, where the two lie in one frame.
  /// \param truth  it is its points that have to lie on the surface: others may be of a floor.
  /// \throws InputError  a file cannot be used.
  TargetPlaces(const std::filesystem::path& path,
               const Shape& target,
               const std::filesystem::path& surface,
               const std::filesystem::path& vertices,
               const std::vector<VertexPair>& truth);

  /// \throws InputError  there is nothing to measure on; names the file.
  TargetMetric metric() const;

  /// Pairs whose target has no place on the mesh are left out.
  std::vector<VertexPair> onMesh(const std::vector<VertexPair>& pairs) const;
  std::vector<SurfacePoint> onMesh(const std::vector<SurfacePoint>& places) const;
  std::vector<int> onMesh(const std::vector<int>& target_vertex) const;

 private:
  int at(int target_vertex) const;
  void placeByRows(const std::filesystem::path& vertices);
  /// False, and nothing is placed, where most of those of the truth lie too far from it.
  bool placeAtNearest(const Points& points, const std::vector<VertexPair>& truth);

  std::filesystem::path path_;  // of what is measured on
  TriangleMesh mesh_;
  bool itself_ = false;
  std::vector<int> vertex_;  // -1: none
};

}  // namespace posture::app
