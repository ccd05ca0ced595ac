// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "result_columns.h"

namespace posture::app {
namespace {

/// The value at `pointer`; empty where there is none.
std::string valueAt(const Json& result, const std::string& pointer) {
  const Json::json_pointer place(pointer);
  if (!result.contains(place) || result.at(place).is_null()) return {};
  const Json& value = result.at(place);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

TextTable tableOf(const std::vector<Json>& results, const std::vector<ResultColumn>& columns) {
  TextTable table;
  for (const ResultColumn& column : columns) table.header.emplace_back(column.name);
  for (const Json& result : results) {
    table.rows.emplace_back();
    for (const ResultColumn& column : columns)
      table.rows.back().push_back(valueAt(result, column.pointer));
  }
  return table;
}

}  // namespace posture::app
