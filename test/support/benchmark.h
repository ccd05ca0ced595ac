// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace posture::test {

/// Tests on the benchmark's shapes; skipped where POSTURE_BENCHMARK does not say where they are.
class BenchmarkTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* const folder = std::getenv("POSTURE_BENCHMARK");
    if (folder == nullptr) GTEST_SKIP() << "POSTURE_BENCHMARK names no folder with the benchmark";
    folder_ = folder;
  }

  std::filesystem::path folder_;
};

}  // namespace posture::test
