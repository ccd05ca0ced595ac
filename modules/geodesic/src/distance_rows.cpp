// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/geodesic/distance_rows.h>
#include <posture/geodesic/fast_marching.h>

#include <mutex>
#include <utility>

namespace posture {

struct DistanceRows::Rows {
  struct Row {
    std::once_flag marched;
    std::vector<double> distance;
  };

  explicit Rows(const TriangleMesh& mesh) : marching(mesh), rows(mesh.vertices.rows()) {}

  FastMarching marching;
  std::vector<Row> rows;
};

DistanceRows::DistanceRows(const TriangleMesh& mesh) : rows_(std::make_unique<Rows>(mesh)) {}
DistanceRows::~DistanceRows() = default;
DistanceRows::DistanceRows(DistanceRows&&) noexcept = default;
DistanceRows& DistanceRows::operator=(DistanceRows&&) noexcept = default;

const std::vector<double>& DistanceRows::from(int source) const {
  require(source >= 0 && source < rows_->marching.vertexCount(), "DistanceRows: no such vertex");
  Rows::Row& row = rows_->rows[source];
  std::call_once(row.marched, [&] {
    GeodesicField field;
    rows_->marching.march(source, field);
    row.distance = std::move(field.distance);
  });
  return row.distance;
}

}  // namespace posture
