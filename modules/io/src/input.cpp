// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input.h"

#include <posture/core/error.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace posture {
namespace fs = std::filesystem;
namespace {

/// LF, CR LF or, of a classic Mac, CR alone, before the byte at `offset`.
std::size_t lineEnds(std::string_view text, std::size_t offset) {
  std::size_t ends = 0;
  for (std::size_t i = 0; i < std::min(offset, text.size()); ++i)
    if (text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n")) ++ends;
  return ends;
}

/// The name of a compressed file's format; empty: it is none.
std::string compressionOf(std::string_view bytes) {
  constexpr std::pair<std::string_view, std::string_view> SIGNATURES[] = {
      {"\x1f\x8b", "gzip"}, {"PK\x03\x04", "ZIP"}, {"BZh", "bzip2"}, {"\xfd\x37zXZ", "xz"}};
  for (const auto& [signature, name] : SIGNATURES)
    if (bytes.substr(0, signature.size()) == signature) return std::string(name);
  return "";
}

/// Text whose lines end with CR alone, as a classic Mac wrote them: with LF instead. What is binary
/// has zeros or, by chance, an LF.
void endLinesWithLf(std::string& bytes) {
  if (bytes.find('\n') == std::string::npos && bytes.find('\0') == std::string::npos)
    std::replace(bytes.begin(), bytes.end(), '\r', '\n');
}

}  // namespace

Input::Input(const fs::path& path) : path_(path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) fail("no such file");
  if (fs::is_directory(status)) fail("is a folder, not a file");
  if (!fs::is_regular_file(status)) fail(error ? error.message() : "not a regular file");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail("cannot be opened: " + std::generic_category().message(errno));
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) fail(error.message());
  if (size == 0) fail("the file is empty");
  try {
    bytes_.resize(size);
  } catch (const std::length_error&) {
    fail("too large for this machine's memory");
  } catch (const std::bad_alloc&) {
    fail("too large for this machine's memory");
  }
  stream.read(bytes_.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size) fail("cannot be read to its end");
  if (const std::string format = compressionOf(bytes_); !format.empty())
    fail("is compressed (" + format + "): unpack it first");
  endLinesWithLf(bytes_);
}

void Input::fail(const std::string& what) const { failAt(NO_OFFSET, what); }

void Input::failAt(std::size_t offset, const std::string& what) const {
  std::string message = onOneLine(path_.string()) + ": ";
  if (offset != NO_OFFSET) message += "line " + std::to_string(1 + lineEnds(bytes_, offset)) + ": ";
  throw InputError(message + what);
}

std::string onOneLine(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return line;
}

std::string inQuotes(std::string_view word) {
  constexpr std::size_t LONGEST = 24;
  std::string text = onOneLine(word.substr(0, LONGEST));
  for (char& c : text)
    if (static_cast<unsigned char>(c) >= 0x80) c = '?';
  return "'" + text + (word.size() > LONGEST ? "...'" : "'");
}

}  // namespace posture
