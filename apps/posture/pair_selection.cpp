// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pair_selection.h"

#include <algorithm>

namespace posture::app {
namespace {

void checkKnown(const std::vector<std::string>& asked,
                const std::vector<BenchmarkPair>& pairs,
                std::string BenchmarkPair::*member,
                const char* what) {
  for (const std::string& name : asked)
    if (std::none_of(pairs.begin(), pairs.end(), [&](const auto& p) { return p.*member == name; }))
      throw CLI::ValidationError(std::string("the list has no ") + what + " '" + name + "'");
}

}  // namespace

bool isAmong(const std::vector<std::string>& asked, const std::string& name) {
  return asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
}

bool PairSelection::has(const BenchmarkPair& pair) const {
  return isAmong(families, pair.family) && isAmong(ids, pair.id);
}

void PairSelection::check(const std::vector<BenchmarkPair>& pairs) const {
  checkKnown(families, pairs, &BenchmarkPair::family, "family");
  checkKnown(ids, pairs, &BenchmarkPair::id, "pair");
  if (!empty() &&
      std::none_of(pairs.begin(), pairs.end(), [&](const auto& pair) { return has(pair); }))
    throw CLI::ValidationError("no pair asked for is of a family asked for");
}

void addSelection(CLI::App& verb, PairSelection& selection) {
  verb.add_option("--family", selection.families, "Only pairs of this family (repeatable)")
      ->expected(1)
      ->take_all();
  verb.add_option("--pair", selection.ids, "Only the pair of this id (repeatable)")
      ->expected(1)
      ->take_all();
}

}  // namespace posture::app
