// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/io/mesh_io.h>

#include "input.h"
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace posture {

/// How the numbers of colours are meant: 0 .. 255, or 0 .. 1 unless one is larger.
enum class ColorRange { BYTE, UNIT };

/// What a vertex is to be that has a coordinate that is not finite: an error, or an error only
/// where there are faces.
enum class Unseen { REFUSED, KEPT_IN_CLOUDS };

/// Collects what a file holds, and checks it.
class MeshBuilder {
 public:
  /// \param index_base  the number of the first vertex in this format, for messages.
  explicit MeshBuilder(const Input& input, Unseen unseen, int index_base = 0)
      : input_(input), unseen_(unseen), index_base_(index_base) {}

  /// The place in a text file that the next calls take their data from.
  void place(std::size_t offset) { offset_ = offset; }

  void reserve(std::size_t vertices, std::size_t faces);
  void addVertex(double x, double y, double z);
  void addNormal(double x, double y, double z) { normals_.insert(normals_.end(), {x, y, z}); }
  void addColor(double r, double g, double b) { colors_.insert(colors_.end(), {r, g, b}); }
  /// Normals for all vertices at once.
  void setNormals(std::vector<double> normals) { normals_ = std::move(normals); }

  /// Vertex numbers from 0, cut into triangles (cutPolygon()); fewer than three corners are
  /// skipped.
  void addPolygon(const std::vector<std::int64_t>& corners);
  /// Each corner makes a triangle with the two before it; -1 begins another strip.
  void addStrip(const std::vector<std::int64_t>& corners);

  std::size_t vertexCount() const { return coordinates_.size() / 3; }

  /// Normals and colours are kept where every vertex has one; of a mesh, finite normals only.
  MeshFile finish(ColorRange range = ColorRange::BYTE);

 private:
  void checkCorner(std::int64_t corner);
  void addTriangle(std::int64_t a, std::int64_t b, std::int64_t c);
  void checkHighestCorner() const;
  /// Once all vertices are known.
  void cutPolygons(const Points& vertices);
  [[noreturn]] void failUnseen(std::size_t vertex, std::size_t offset) const;

  const Input& input_;
  Unseen unseen_;
  int index_base_;
  std::size_t offset_ = NO_OFFSET;
  std::vector<double> coordinates_, normals_, colors_;
  std::vector<int> corners_;
  /// Polygons of more than three corners: their first triangle, and how many; fans so far.
  std::vector<std::pair<std::size_t, int>> polygons_;
  std::optional<std::pair<std::size_t, std::size_t>> first_unseen_;  // vertex, offset
  std::int64_t highest_corner_ = -1;
  std::size_t highest_corner_offset_ = NO_OFFSET;
};

}  // namespace posture
