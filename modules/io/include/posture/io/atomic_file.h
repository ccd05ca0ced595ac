// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>

namespace posture {

/// A file that appears whole or not at all: written beside its final place under another name and
/// moved there by commit(). Without commit() (an exception, an early return) nothing is left.
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
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
  bool committed_ = false;
};

}  // namespace posture
