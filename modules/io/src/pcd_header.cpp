// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcd_header.h"

#include "text_reader.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace posture {
namespace {

class PcdHeaderReader {
 public:
  explicit PcdHeaderReader(const Input& input) : text_(input, 0, '#') {}

  PcdHeader read() {
    std::string_view word = text_.word();
    while (word != "DATA") {
      if (word.empty()) text_.fail("truncated: the header has no DATA line");
      readLine(word);
      text_.skipLine();
      word = text_.word();
    }
    readEncoding();
    text_.skipLine();
    header_.size = text_.offset();
    setTypes();
    setSizes();
    return std::move(header_);
  }

 private:
  void readLine(std::string_view key) {
    if (key == "FIELDS" || key == "COLUMNS") {
      for (const std::string_view word : words()) header_.fields.push_back({std::string(word)});
    } else if (key == "SIZE") {
      sizes_ = words();
    } else if (key == "TYPE") {
      types_ = words();
    } else if (key == "COUNT") {
      counts_ = words();
    } else if (key == "WIDTH") {
      width_ = number("WIDTH");
    } else if (key == "HEIGHT") {
      height_ = number("HEIGHT");
    } else if (key == "POINTS") {
      points_ = number("POINTS");
    } else if (key == "VIEWPOINT") {
      readViewpoint();
    } else if (key != "VERSION") {
      text_.fail(inQuotes(key) + " is not a PCD header line");
    }
  }

  std::vector<std::string_view> words() {
    std::vector<std::string_view> all;
    for (std::string_view word = text_.wordOnLine(); !word.empty(); word = text_.wordOnLine())
      all.push_back(word);
    return all;
  }

  std::size_t number(const char* what) {
    const std::int64_t value = text_.integer(text_.wordOnLine(), what);
    if (value < 0 || value >= std::numeric_limits<int>::max())
      text_.fail(std::string(what) + " is out of range: " + std::to_string(value));
    return static_cast<std::size_t>(value);
  }

  void readViewpoint() {
    for (int i = 0; i < 7; ++i) {
      const double value = text_.number(text_.wordOnLine(), "VIEWPOINT");
      if (!std::isfinite(value)) text_.fail("VIEWPOINT is not finite");
      if (i < 3) header_.viewpoint[i] = value;
    }
  }

  void readEncoding() {
    const std::string_view word = text_.wordOnLine();
    if (word == "ascii")
      header_.encoding = PcdEncoding::ASCII;
    else if (word == "binary")
      header_.encoding = PcdEncoding::BINARY;
    else if (word == "binary_compressed")
      header_.encoding = PcdEncoding::COMPRESSED;
    else
      text_.fail("DATA " + inQuotes(word) +
                 " where ascii, binary or binary_compressed is expected");
  }

  /// SIZE, TYPE and COUNT may be missing: 4-byte numbers, one a field.
  void setTypes() {
    if (header_.fields.empty()) text_.fail("the header has no FIELDS");
    checkLength(sizes_, "SIZE");
    checkLength(types_, "TYPE");
    checkLength(counts_, "COUNT");
    for (std::size_t i = 0; i < header_.fields.size(); ++i) {
      PcdField& field = header_.fields[i];
      field.type = typeOf(types_.empty() ? "F" : types_[i], sizes_.empty() ? "4" : sizes_[i]);
      if (counts_.empty()) continue;
      const std::int64_t count = text_.integer(counts_[i], "COUNT");
      // A field may be empty, but no larger than the file.
      if (count < 0 || static_cast<std::size_t>(count) > text_.offset() + text_.remaining())
        text_.fail("COUNT " + std::to_string(count) + " is out of range");
      field.count = static_cast<std::size_t>(count);
    }
  }

  void checkLength(const std::vector<std::string_view>& words, const char* key) const {
    if (!words.empty() && words.size() != header_.fields.size())
      text_.fail(std::string(key) + " has " + std::to_string(words.size()) + " entries for " +
                 std::to_string(header_.fields.size()) + " fields");
  }

  Scalar typeOf(std::string_view type, std::string_view size) const {
    struct Known {
      std::string_view type, size;
      Scalar scalar;
    };
    constexpr Known KNOWN[] = {{"F", "4", Scalar::FLOAT},
                               {"F", "8", Scalar::DOUBLE},
                               {"I", "1", Scalar::INT8},
                               {"I", "2", Scalar::INT16},
                               {"I", "4", Scalar::INT32},
                               {"I", "8", Scalar::INT64},
                               {"U", "1", Scalar::UINT8},
                               {"U", "2", Scalar::UINT16},
                               {"U", "4", Scalar::UINT32},
                               {"U", "8", Scalar::UINT64}};
    for (const Known& known : KNOWN)
      if (type == known.type && size == known.size) return known.scalar;
    text_.fail("unknown TYPE " + inQuotes(type) + " of SIZE " + inQuotes(size));
  }

  void setSizes() {
    header_.height = std::max<std::size_t>(height_.value_or(1), 1);
    header_.points = points_.value_or(width_.value_or(0) * header_.height);
    header_.width = width_.value_or(header_.points / header_.height);
    if (header_.points == 0) text_.fail("there are no points in it");
    if (header_.points >= static_cast<std::size_t>(std::numeric_limits<int>::max()))
      text_.fail("POINTS is out of range: " + std::to_string(header_.points));
    if (header_.width * header_.height != header_.points)
      text_.fail("WIDTH " + std::to_string(header_.width) + " times HEIGHT " +
                 std::to_string(header_.height) + " is not POINTS " +
                 std::to_string(header_.points));
    const bool ascii = header_.encoding == PcdEncoding::ASCII;
    std::size_t smallest = 0;
    for (const PcdField& field : header_.fields)
      smallest += ascii ? 2 * field.count : field.bytes();
    const std::size_t left = text_.remaining() + (ascii ? 1 : 0);
    if (header_.encoding != PcdEncoding::COMPRESSED && smallest != 0 &&
        header_.points > left / smallest)
      text_.fail("truncated: its header says " + std::to_string(header_.points) +
                 " points, too many for the size of the file");
  }

  TextReader text_;
  PcdHeader header_;
  std::vector<std::string_view> sizes_, types_, counts_;
  std::optional<std::size_t> width_, height_, points_;
};

}  // namespace

int PcdHeader::find(std::initializer_list<std::string_view> names) const {
  for (const std::string_view wanted : names)
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i].name == wanted && fields[i].count > 0) return static_cast<int>(i);
  return -1;
}

std::size_t PcdHeader::record() const {
  std::size_t bytes = 0;
  for (const PcdField& field : fields) bytes += field.bytes();
  return bytes;
}

PcdHeader readPcdHeader(const Input& input) { return PcdHeaderReader(input).read(); }

}  // namespace posture
