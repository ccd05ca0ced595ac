// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/atomic_file.h>

#include "input.h"
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
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

/// What a link stands for, be it there or not, through links to links.
fs::path behindLinks(fs::path path) {
  constexpr int MOST_LINKS = 40;  // as of the system
  std::error_code error;
  for (int i = 0; fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    if (i == MOST_LINKS) failToWrite(path, "too many links lead to each other");
    path = path.parent_path() / fs::read_symlink(path, error);
    if (error) failToWrite(path, error.message());
  }
  return path;
}

fs::path temporaryBeside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  const std::string name = ".posture-" + std::to_string(::getpid()) + "-" +
                           std::to_string(counter.fetch_add(1)) + ".tmp";
  return path.parent_path() / name;
}

/// A file without a name in that folder, which ends with the process whatever ends that; -1 where
/// the file system has none.
int openUnnamed(fs::path folder) {
  if (folder.empty()) folder = ".";
  return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

std::string openFilePath(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

/// False where there is such a file.
bool makeEmpty(const fs::path& path, mode_t mode) {
  const int descriptor = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
  return descriptor >= 0 && ::close(descriptor) == 0;
}

/// Gives an open file a name; false where that name is taken.
bool nameFile(int descriptor, const fs::path& path) {
  return ::linkat(AT_FDCWD,
                  openFilePath(descriptor).c_str(),
                  AT_FDCWD,
                  path.c_str(),
                  AT_SYMLINK_FOLLOW) == 0;
}

/// Who might read and write the one file may do so with the other; its group where that cannot be
/// given may not.
void handDown(const fs::path& from, const std::string& to) {
  struct stat before {};
  if (::stat(from.c_str(), &before) != 0) return;
  mode_t mode = before.st_mode & 0777;
  if (::chown(to.c_str(), before.st_uid, before.st_gid) != 0 &&
      ::chown(to.c_str(), static_cast<uid_t>(-1), before.st_gid) != 0)
    mode &= ~070U;
  if (::chmod(to.c_str(), mode) != 0) return;  // on some file systems all are as they are
}

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::is_directory(status)) failToWrite(path_, "is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) failToWrite(path_, "not a regular file");
  if (!path_.has_filename()) failToWrite(path_, "no file name");
  // The move would replace a link by a file; what it points to is meant.
  path_ = behindLinks(path_);
  unnamed_ = openUnnamed(path_.parent_path());
  if (unnamed_ >= 0) stream_.open(openFilePath(unnamed_), std::ios::binary);
  if (stream_.is_open()) return;
  closeUnnamed();
  const mode_t mode = fs::exists(status) ? 0600 : 0666;
  takeTemporaryName([mode](const fs::path& name) { return makeEmpty(name, mode); });
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (stream_) return;
  const std::string reason = reasonOf(errno);
  removeTemporary();
  failToWrite(path_, reason);
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  if (unnamed_ < 0) removeTemporary();
  closeUnnamed();
}

void AtomicFile::commit() {
  if (committed_) return;
  errno = 0;
  stream_.flush();
  stream_.close();
  if (!stream_) failToWrite(path_, errno == 0 ? "the disk may be full" : reasonOf(errno));
  handDown(path_, unnamed_ >= 0 ? openFilePath(unnamed_) : temporary_.string());
  // A name can be given but not taken over: over another file only a move goes.
  if (unnamed_ < 0 || !nameFile(unnamed_, path_)) moveIntoPlace();
  closeUnnamed();
  committed_ = true;
}

void AtomicFile::takeTemporaryName(const std::function<bool(const fs::path&)>& take) {
  do {
    temporary_ = temporaryBeside(path_);
    errno = 0;
    if (take(temporary_)) return;
  } while (errno == EEXIST);  // left by a run before, of the same number
  failToWrite(path_, reasonOf(errno));
}

void AtomicFile::moveIntoPlace() {
  if (unnamed_ >= 0)
    takeTemporaryName([this](const fs::path& name) { return nameFile(unnamed_, name); });
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (!error) return;
  removeTemporary();
  failToWrite(path_, error.message());
}

void AtomicFile::removeTemporary() {
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFile::closeUnnamed() {
  if (unnamed_ >= 0) ::close(unnamed_);
  unnamed_ = -1;
}

void writeFile(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.stream() << bytes;
  file.commit();
}

}  // namespace posture
