// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "table_layout.h"

#include "color_byte.h"
#include "text.h"
#include "text_reader.h"
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

namespace posture {
namespace {

using Columns = TableLayout::Columns;

/// Small letters, without quotes and without a unit in brackets.
std::string plainName(std::string_view name) {
  std::string plain = lowercase(trimmed(name.substr(0, name.find_first_of("(["))));
  plain.erase(std::remove(plain.begin(), plain.end(), '"'), plain.end());
  return plain;
}

bool complete(const Columns& columns) {
  return std::all_of(columns.begin(), columns.end(), [](int column) { return column >= 0; });
}

/// What three neighbouring columns hold: seen from all their rows, those that are not finite or
/// zero left aside.
ColumnMeaning meaningOf(const std::vector<double>& numbers, int columns, int first) {
  constexpr double UNIT_TOLERANCE = 0.01;  // numbers of two or three digits
  bool any = false, unit = true, bytes = true, shares = true;
  for (auto row = static_cast<std::size_t>(first); row < numbers.size();
       row += static_cast<std::size_t>(columns)) {
    const double* const v = &numbers[row];
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (!std::isfinite(square) || square == 0) continue;
    any = true;
    unit = unit && std::abs(std::sqrt(square) - 1) < UNIT_TOLERANCE;
    for (int i = 0; i < 3; ++i) {
      bytes = bytes && v[i] >= 0 && v[i] <= 255 && v[i] == std::floor(v[i]);
      shares = shares && v[i] >= 0 && v[i] <= 1;
    }
  }
  if (!any) return ColumnMeaning::UNKNOWN;
  return unit              ? ColumnMeaning::NORMAL
         : bytes || shares ? ColumnMeaning::COLOR
                           : ColumnMeaning::UNKNOWN;
}

Points columnsOf(const std::vector<double>& numbers, int columns, const Columns& wanted) {
  if (!complete(wanted)) return Points(0, 3);
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
      table(numbers.data(), static_cast<Eigen::Index>(numbers.size()) / columns, columns);
  Points part(table.rows(), 3);
  for (int axis = 0; axis < 3; ++axis)
    part.col(axis) = table.col(wanted[static_cast<std::size_t>(axis)]);
  return part;
}

}  // namespace

std::optional<TableLayout> layoutOfNames(const std::vector<std::string_view>& names) {
  std::vector<std::string> plain;
  plain.reserve(names.size());
  for (const std::string_view name : names) plain.push_back(plainName(name));
  const auto find = [&](std::initializer_list<const char*> wanted) {
    for (const char* const one : wanted)
      for (std::size_t i = 0; i < plain.size(); ++i)
        if (plain[i] == one) return static_cast<int>(i);
    return -1;
  };
  TableLayout layout;
  layout.position = {find({"x", "points:0", "points_0"}),
                     find({"y", "points:1", "points_1"}),
                     find({"z", "points:2", "points_2"})};
  if (!complete(layout.position)) return std::nullopt;
  layout.normal = {find({"nx", "normal_x", "normals:0", "normals_0"}),
                   find({"ny", "normal_y", "normals:1", "normals_1"}),
                   find({"nz", "normal_z", "normals:2", "normals_2"})};
  layout.color = {find({"r", "red", "rf"}), find({"g", "green", "gf"}), find({"b", "blue", "bf"})};
  return layout;
}

bool namesLackZ(const std::vector<std::string_view>& names) {
  return names.size() >= 2 && plainName(names[0]) == "x" && plainName(names[1]) == "y" &&
         !layoutOfNames(names);
}

TableLayout layoutOfNumbers(const std::vector<double>& numbers,
                            int columns,
                            ColumnMeaning behind_position) {
  TableLayout layout;
  if (behind_position != ColumnMeaning::UNKNOWN && columns >= 6) {
    (behind_position == ColumnMeaning::NORMAL ? layout.normal : layout.color) = {3, 4, 5};
    return layout;
  }
  const auto take = [&](int first) {
    const ColumnMeaning meaning = meaningOf(numbers, columns, first);
    Columns& wanted = meaning == ColumnMeaning::NORMAL ? layout.normal : layout.color;
    if (meaning == ColumnMeaning::UNKNOWN || complete(wanted)) return false;
    wanted = {first, first + 1, first + 2};
    return true;
  };
  if (columns == 6) take(3);
  if (columns == 7 && (meaningOf(numbers, columns, 3) == ColumnMeaning::NORMAL || !take(4)))
    take(3);
  if (columns == 9) {
    take(3);
    take(6);
  }
  return layout;
}

PointCloud toCloud(const std::vector<double>& numbers, int columns, const TableLayout& layout) {
  PointCloud cloud;
  cloud.points = columnsOf(numbers, columns, layout.position);
  cloud.normals = columnsOf(numbers, columns, layout.normal);
  const Points colors = columnsOf(numbers, columns, layout.color);
  cloud.colors.resize(colors.rows(), 3);
  bool shares = true, fractions = false;
  for (const double value : colors.reshaped()) {
    shares = shares && !(value > 1);
    fractions = fractions || (value > 0 && value < 1);
  }
  const double scale = shares && fractions ? 255 : 1;
  for (Eigen::Index i = 0; i < colors.rows(); ++i)
    for (int c = 0; c < 3; ++c) cloud.colors(i, c) = colorByte(scale * colors(i, c));
  return cloud;
}

}  // namespace posture
