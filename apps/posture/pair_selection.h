// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/evaluation/pair_list.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace posture::app {

/// Pairs of a list that are asked for by --family and --pair; all where neither is given.
struct PairSelection {
  std::vector<std::string> families, ids;

  bool empty() const { return families.empty() && ids.empty(); }
  bool has(const BenchmarkPair& pair) const;
  /// \throws CLI::ValidationError  the list has no such family or pair.
  void check(const std::vector<BenchmarkPair>& pairs) const;
};

/// No name asked for stands for all.
bool isAmong(const std::vector<std::string>& asked, const std::string& name);

void addSelection(CLI::App& verb, PairSelection& selection);

}  // namespace posture::app
