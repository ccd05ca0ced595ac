// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/files.h"

#include <atomic>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace posture::test {
namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  static std::atomic<int> counter{0};
  path_ = fs::temp_directory_path() /
          ("posture-test-io-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::file(const std::string& name, const std::string& bytes) const {
  const fs::path path = path_ / name;
  // Overwriting a file makes ext4 wait for the disk.
  fs::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

int TemporaryFolder::entryCount() const {
  return static_cast<int>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
}

std::string bytesOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace posture::test
