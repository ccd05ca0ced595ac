// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/evaluation/pair_list.h>

#include "json_document.h"
#include <cstdint>
#include <string>
#include <vector>

namespace posture::app {

struct ComparedMethod {
  std::string key;   ///< "icp", as options and files have it
  std::string name;  ///< "ICP", as tables have it
};

/// Posture, the source as it is given, and PCL's rigid ones.
const std::vector<ComparedMethod>& comparedMethods();

/// One method on one variation of a pair.
struct ComparedRun {
  BenchmarkPair pair;
  std::string method, variation;  ///< keys
  std::uint64_t seed = 1;
};

/// The part of a result that names its run, and the way back.
Json describeRun(const ComparedRun& run);
ComparedRun comparedRun(const Json& described);

/// Files that cannot be used end in a result that says so, `not run`; what the method alone cannot
/// work with as well, `refused`.
Json runCompared(const ComparedRun& run);

/// Of a pair with a truth: the run failed or was refused, and so missed all of it.
bool missedAll(const Json& result);

}  // namespace posture::app
