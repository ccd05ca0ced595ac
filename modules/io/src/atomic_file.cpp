// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/atomic_file.h>

#include "input.h"
#include <atomic>
#include <cerrno>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace posture {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void failToWrite(const fs::path& path, const std::string& reason) {
  throw InputError(onOneLine(path.string()) + ": cannot be written: " + reason);
}

std::string reasonOf(int error) {
  return error == 0 ? "unknown reason" : std::generic_category().message(error);
}

fs::path temporaryBeside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  const std::string name = ".posture-" + std::to_string(::getpid()) + "-" +
                           std::to_string(counter.fetch_add(1)) + ".tmp";
  return path.parent_path() / name;
}

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::is_directory(status)) failToWrite(path_, "is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) failToWrite(path_, "not a regular file");
  if (!path_.has_filename()) failToWrite(path_, "no file name");
  // The move would replace a link by a file; what it points to is meant.
  if (fs::exists(status) && fs::is_symlink(fs::symlink_status(path_, ignored)))
    path_ = fs::canonical(path_, ignored);
  temporary_ = temporaryBeside(path_);
  errno = 0;
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) failToWrite(path_, reasonOf(errno));
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  if (committed_) return;
  errno = 0;
  stream_.flush();
  stream_.close();
  if (!stream_) failToWrite(path_, errno == 0 ? "the disk may be full" : reasonOf(errno));
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error) failToWrite(path_, error.message());
  committed_ = true;
}

}  // namespace posture
