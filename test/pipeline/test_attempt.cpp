// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "answer/attempt.h"
#include "pipeline/made_up_answers.h"

namespace posture {
namespace {

using test::answerWith;

TEST(Attempt, isChangedBeforeAndAfterItIsFinished) {
  const Attempt attempt = withChange({answerWith(-12, 1), [] { return answerWith(-12, 2); }},
                                     [](RegistrationResult& result) { ++result.source.samples; });
  EXPECT_EQ(attempt.found.source.samples, 1);
  EXPECT_EQ(finished(attempt).source.samples, 1);
  EXPECT_EQ(finished(attempt).correspondence.on_target[0].vertex, 2);
}

}  // namespace
}  // namespace posture
