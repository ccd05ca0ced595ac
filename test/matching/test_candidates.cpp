// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/matching/candidates.h>

#include <gtest/gtest.h>

namespace posture {
namespace {

CanonicalForm formOf(const Points& landmarks) {
  CanonicalForm form;
  form.landmarks = landmarks;
  return form;
}

TEST(AlignmentCandidates, oneOfThemUndoesAnyReflection) {
  Rng rng(1);
  Points points(60, 3);
  for (int i = 0; i < points.size(); ++i) points.data()[i] = rng.normal();
  for (const Eigen::RowVector3d& flip : {Eigen::RowVector3d(1, 1, 1), {-1, 1, -1}, {1, -1, 1}}) {
    const Points flipped = (points.array().rowwise() * flip.array()).matrix();
    const auto candidates = alignmentCandidates(formOf(points), formOf(flipped));
    ASSERT_EQ(candidates.size(), 8);
    int perfect = 0;
    for (const Candidate& c : candidates) {
      ASSERT_EQ(c.matches.size(), 60);
      if (c.cost > 1e-9) continue;
      ++perfect;
      for (int k = 0; k < 3; ++k) EXPECT_EQ(c.axis_signs[k], flip[k]);
      for (const Match& m : c.matches) EXPECT_EQ(m.source, m.target);
    }
    EXPECT_EQ(perfect, 1);
  }
}

TEST(AlignmentCandidates, leaveSamplesOverWhereTheSidesDiffer) {
  const Points many = Points::Random(30, 3), few = many.topRows(20);
  for (const auto& candidates : {alignmentCandidates(formOf(many), formOf(few)),
                                 alignmentCandidates(formOf(few), formOf(many))}) {
    ASSERT_EQ(candidates.size(), 8);
    for (const Candidate& c : candidates) EXPECT_EQ(c.matches.size(), 20);
  }
}

}  // namespace
}  // namespace posture
