// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/finalists/finalists.h"
#include <cstddef>
#include <vector>

namespace posture {

/// Of finalists by increasing score, the first and those that differ from every better one by more
/// than `gap`: different answers.
std::vector<int> distinctFinalists(const std::vector<Finalist>& finalists,
                                   const TriangleMesh& target,
                                   double gap);

/// Whether a finalist convinces that has let nothing go: less of a body always fits a little
/// better.
bool anyConvincesWhole(const std::vector<Finalist>& finalists);

/// Whether the best finalist scores, alone and beside the next different one, so that tips need not
/// be matched as well. \pre  there is one.
bool isAllButCertain(const std::vector<Finalist>& finalists, const std::vector<int>& distinct);

/// In their order those of the answers that are kept, and the first others if there are fewer than
/// `most`.
std::vector<int> foremost(const std::vector<int>& answers,
                          const std::vector<int>& kept,
                          std::size_t most);

/// Those worth refining: the first one, the best of other answers whose scores are too near to
/// decide, and one that was laid if there is any, also of the same answer.
std::vector<int> leadingOf(const std::vector<Finalist>& finalists,
                           const std::vector<int>& distinct);

}  // namespace posture
