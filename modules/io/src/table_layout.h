// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace posture {

/// Which columns of a table of points hold what; -1: none.
struct TableLayout {
  using Columns = std::array<int, 3>;
  static constexpr Columns NONE = {-1, -1, -1};

  Columns position = {0, 1, 2}, normal = NONE, color = NONE;
};

/// The first line of a table, if it names the columns x, y and z.
std::optional<TableLayout> layoutOfNames(const std::vector<std::string_view>& names);

/// Whether a line names the columns x and y, these first, and none z.
bool namesLackZ(const std::vector<std::string_view>& names);

enum class ColumnMeaning { UNKNOWN, NORMAL, COLOR };

/// For a table without names, rows of `columns` numbers.
/// \param behind_position  what the file's ending says of the fourth to sixth column.
TableLayout layoutOfNumbers(const std::vector<double>& numbers,
                            int columns,
                            ColumnMeaning behind_position = ColumnMeaning::UNKNOWN);

PointCloud toCloud(const std::vector<double>& numbers, int columns, const TableLayout& layout);

}  // namespace posture
