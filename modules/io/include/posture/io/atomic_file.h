// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <string_view>

namespace posture {

/// A file that appears whole or not at all, whatever ends the process: it has no name before
/// commit(). Without commit() - an exception, an early return, a signal - nothing is left. On file
/// systems without such files (NFS) it has a hidden name beside its place meanwhile, which a signal
/// leaves behind. A file written over hands down its owner and group, as far as the process may,
/// and its permissions. When the machine itself stops, what was committed last may be lost or cut
/// short.
class AtomicFile {
 public:
  /// \throws InputError  the folder does not exist or cannot be written to.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }

  /// \throws InputError  something could not be written (disk full), or the move failed.
  void commit();

 private:
  /// \param take  gives a file that name; false, and EEXIST, where it is taken.
  void takeTemporaryName(const std::function<bool(const std::filesystem::path&)>& take);
  void moveIntoPlace();
  void removeTemporary();
  void closeUnnamed();

  std::filesystem::path path_;
  std::filesystem::path temporary_;  // the name beside path_ while there is need of one
  int unnamed_ = -1;                 // descriptor of the file without a name; -1: it has one
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes the whole file or nothing, as AtomicFile does.
/// \throws InputError  as AtomicFile.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace posture
