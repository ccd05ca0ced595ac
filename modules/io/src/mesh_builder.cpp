// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_builder.h"

#include <posture/core/error.h>
#include <posture/io/cut_polygon.h>

#include "color_byte.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace posture {
namespace {

constexpr std::int64_t MOST_NUMBERS = std::numeric_limits<int>::max();

/// Their half-edges are numbered, too.
constexpr std::int64_t MOST_FACES = MOST_NUMBERS / 3;

bool allFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Points toPoints(const std::vector<double>& values) {
  return Eigen::Map<const Points>(values.data(), static_cast<Eigen::Index>(values.size() / 3), 3);
}

}  // namespace

void MeshBuilder::reserve(std::size_t vertices, std::size_t faces) {
  coordinates_.reserve(3 * vertices);
  corners_.reserve(3 * faces);
}

void MeshBuilder::addVertex(double x, double y, double z) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
    if (unseen_ == Unseen::REFUSED) failUnseen(vertexCount(), offset_);
    if (!first_unseen_) first_unseen_.emplace(vertexCount(), offset_);
  }
  coordinates_.insert(coordinates_.end(), {x, y, z});
}

void MeshBuilder::failUnseen(std::size_t vertex, std::size_t offset) const {
  input_.failAt(offset,
                "vertex " + std::to_string(vertex + static_cast<std::size_t>(index_base_)) +
                    " has a coordinate that is not finite");
}

void MeshBuilder::checkCorner(std::int64_t corner) {
  if (corner < 0 || corner >= MOST_NUMBERS)
    input_.failAt(offset_, "face index " + std::to_string(corner) + " is out of range");
  if (corner > highest_corner_) {
    highest_corner_ = corner;
    highest_corner_offset_ = offset_;
  }
}

void MeshBuilder::addTriangle(std::int64_t a, std::int64_t b, std::int64_t c) {
  corners_.insert(corners_.end(), {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
}

void MeshBuilder::addPolygon(const std::vector<std::int64_t>& corners) {
  for (const std::int64_t corner : corners) checkCorner(corner);
  if (corners.size() > 3)
    polygons_.emplace_back(corners_.size() / 3, static_cast<int>(corners.size()) - 2);
  for (std::size_t i = 2; i < corners.size(); ++i)
    addTriangle(corners[0], corners[i - 1], corners[i]);
}

void MeshBuilder::cutPolygons(const Points& vertices) {
  for (const auto& [first, count] : polygons_) {
    const auto begin = corners_.begin() + static_cast<std::ptrdiff_t>(3 * first);
    std::vector<int> polygon{begin[0], begin[1]};
    for (int i = 0; i < count; ++i) polygon.push_back(begin[3 * i + 2]);
    const std::vector<std::array<int, 3>> triangles = cutPolygon(vertices(polygon, Eigen::all));
    require(static_cast<int>(triangles.size()) == count, "cutPolygon: not as many as a fan has");
    auto at = begin;
    for (const std::array<int, 3>& triangle : triangles)
      for (int corner : triangle) *at++ = polygon[corner];
  }
}

void MeshBuilder::addStrip(const std::vector<std::int64_t>& corners) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] == -1) {
      begin = i + 1;
      continue;
    }
    checkCorner(corners[i]);
    if (i < begin + 2) continue;
    const bool odd = (i - begin) % 2 == 1;
    addTriangle(corners[odd ? i - 1 : i - 2], corners[odd ? i - 2 : i - 1], corners[i]);
  }
}

void MeshBuilder::checkHighestCorner() const {
  if (highest_corner_ < static_cast<std::int64_t>(vertexCount())) return;
  input_.failAt(highest_corner_offset_,
                "face index " + std::to_string(highest_corner_ + index_base_) +
                    " is out of range, the file has " + std::to_string(vertexCount()) +
                    " vertices");
}

MeshFile MeshBuilder::finish(ColorRange range) {
  if (coordinates_.empty()) input_.fail("there are no vertices in it");
  if (coordinates_.size() / 3 >= static_cast<std::size_t>(MOST_NUMBERS) ||
      corners_.size() / 3 > static_cast<std::size_t>(MOST_FACES))
    input_.fail("more vertices or faces than can be numbered");
  checkHighestCorner();
  if (first_unseen_ && !corners_.empty()) failUnseen(first_unseen_->first, first_unseen_->second);
  const bool is_cloud = unseen_ == Unseen::KEPT_IN_CLOUDS && corners_.empty();
  MeshFile file;
  file.mesh.vertices = toPoints(coordinates_);
  cutPolygons(file.mesh.vertices);
  file.mesh.faces =
      Eigen::Map<const Faces>(corners_.data(), static_cast<Eigen::Index>(corners_.size() / 3), 3);
  if (normals_.size() == coordinates_.size() && (is_cloud || allFinite(normals_)))
    file.normals = toPoints(normals_);
  if (colors_.size() == coordinates_.size()) {
    const bool shares =
        std::none_of(colors_.begin(), colors_.end(), [](double c) { return c > 1; });
    const double scale = range == ColorRange::UNIT && shares ? 255 : 1;
    file.colors.resize(file.mesh.vertices.rows(), 3);
    std::transform(colors_.begin(), colors_.end(), file.colors.data(), [scale](double value) {
      return colorByte(scale * value);
    });
  }
  return file;
}

}  // namespace posture
