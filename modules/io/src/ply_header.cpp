// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include "text_reader.h"
#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace posture {
namespace {

class HeaderReader {
 public:
  explicit HeaderReader(const Input& input) : text_(input) {}

  PlyHeader read() {
    if (text_.wordOnLine() != "ply") text_.fail("does not begin with 'ply'");
    bool has_format = false;
    for (;;) {
      if (!text_.nextLine()) text_.fail("truncated: the header has no end_header");
      const std::string_view word = text_.wordOnLine();
      if (word == "end_header") break;
      if (word == "format")
        has_format = readFormat();
      else if (word == "element")
        readElement();
      else if (word == "property")
        readProperty();
      else if (word != "comment" && word != "obj_info")
        text_.fail(inQuotes(word) + " is not a PLY header line");
    }
    if (!has_format) text_.fail("the header names no format");
    text_.skipLine();
    header_.size = text_.offset();
    return std::move(header_);
  }

 private:
  bool readFormat() {
    const std::string_view word = text_.wordOnLine();
    header_.ascii = word == "ascii";
    header_.order = word == "binary_big_endian" ? ByteOrder::BIG : ByteOrder::LITTLE;
    if (!header_.ascii && word != "binary_little_endian" && word != "binary_big_endian")
      text_.fail("unknown format " + inQuotes(word));
    return true;
  }

  void readElement() {
    PlyElement element;
    element.name = text_.wordOnLine();
    const std::string what = "the number of " + inQuotes(element.name);
    const std::int64_t count = text_.integer(text_.wordOnLine(), what.c_str());
    if (count < 0) text_.fail(what + " is negative: " + std::to_string(count));
    element.count = static_cast<std::size_t>(count);
    if (!names_.insert(element.name).second)
      text_.fail("a second element " + inQuotes(element.name));
    header_.elements.push_back(std::move(element));
  }

  void readProperty() {
    if (header_.elements.empty()) text_.fail("a property before any element");
    PlyProperty property;
    std::string_view word = text_.wordOnLine();
    property.is_list = word == "list";
    if (property.is_list) {
      property.count_type = readType(text_.wordOnLine());
      word = text_.wordOnLine();
    }
    property.type = readType(word);
    property.name = text_.wordOnLine();
    if (property.name.empty()) text_.fail("a property without a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  Scalar readType(std::string_view name) const {
    static const std::pair<std::string_view, Scalar> TYPES[] = {{"char", Scalar::INT8},
                                                                {"int8", Scalar::INT8},
                                                                {"uchar", Scalar::UINT8},
                                                                {"uint8", Scalar::UINT8},
                                                                {"short", Scalar::INT16},
                                                                {"int16", Scalar::INT16},
                                                                {"ushort", Scalar::UINT16},
                                                                {"uint16", Scalar::UINT16},
                                                                {"int", Scalar::INT32},
                                                                {"int32", Scalar::INT32},
                                                                {"uint", Scalar::UINT32},
                                                                {"uint32", Scalar::UINT32},
                                                                {"int64", Scalar::INT64},
                                                                {"uint64", Scalar::UINT64},
                                                                {"float", Scalar::FLOAT},
                                                                {"float32", Scalar::FLOAT},
                                                                {"double", Scalar::DOUBLE},
                                                                {"float64", Scalar::DOUBLE}};
    for (const auto& [known, type] : TYPES)
      if (name == known) return type;
    text_.fail("unknown property type " + inQuotes(name));
  }

  TextReader text_;
  PlyHeader header_;
  std::set<std::string> names_;  // of elements
};

}  // namespace

int PlyElement::find(std::initializer_list<std::string_view> names) const {
  for (const std::string_view wanted : names)
    for (std::size_t i = 0; i < properties.size(); ++i)
      if (properties[i].name == wanted) return static_cast<int>(i);
  return -1;
}

PlyHeader readPlyHeader(const Input& input) { return HeaderReader(input).read(); }

}  // namespace posture
