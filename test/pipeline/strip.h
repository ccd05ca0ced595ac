// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "refined/refinement/refined_maps.h"
#include "support/shapes.h"
#include <cmath>

namespace posture::test {

/// Maps of a strip of 21 columns, 0.05 apart, to one column of it.
class StripTest : public testing::Test {
 protected:
  const TriangleMesh strip_ = grid(20, 1, 1, 0.05);

  /// All of it to one column.
  VertexMaps mapTo(int column) const {
    VertexMaps maps;
    maps.forward.assign(strip_.vertices.rows(), column);
    return maps;
  }

  Finalist finalist(int column, double score = 0) const {
    Finalist f;
    f.maps = mapTo(column);
    f.score = scoring(score);
    return f;
  }

  static MapScore scoring(double total) {
    MapScore score;
    score.bending = score.curvature = score.distortion = score.return_miss = std::exp(total / 4);
    return score;
  }

  RefinedMap refined(int finalist, int column, double score) const {
    RefinedMap map;
    map.finalist = finalist;
    map.pair.maps = mapTo(column);
    map.score = scoring(score);
    return map;
  }
};

}  // namespace posture::test
