// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace posture {

constexpr std::size_t NO_OFFSET = static_cast<std::size_t>(-1);

/// A whole file in memory, and the way to say what is wrong with it.
class Input {
 public:
  /// \throws InputError  missing, not a regular file, empty, unreadable, too large or compressed.
  explicit Input(const std::filesystem::path& path);

  std::string_view bytes() const { return bytes_; }
  const std::filesystem::path& path() const { return path_; }

  [[noreturn]] void fail(const std::string& what) const;
  /// Names the line that holds the byte at `offset`; NO_OFFSET: as fail().
  [[noreturn]] void failAt(std::size_t offset, const std::string& what) const;

 private:
  std::filesystem::path path_;
  std::string bytes_;
};

/// `text` with every control character replaced by '?'.
std::string onOneLine(std::string_view text);

/// A word of a file as a message may show it: in quotes, printable ASCII, not long.
std::string inQuotes(std::string_view word);

}  // namespace posture
