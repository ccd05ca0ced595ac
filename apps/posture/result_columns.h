// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/report/table.h>

#include "json_document.h"
#include <string>
#include <vector>

namespace posture::app {

struct ResultColumn {
  const char* name;
  const char* pointer;  ///< JSON pointer into a result
};

/// A row a result; empty where it has no such value.
TextTable tableOf(const std::vector<Json>& results, const std::vector<ResultColumn>& columns);

}  // namespace posture::app
