// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_builder.h"
#include "ply_header.h"
#include "readers.h"
#include "text.h"
#include "text_reader.h"
#include <array>
#include <string>
#include <vector>

namespace posture {
namespace {

/// The numbers behind an ASCII header.
class AsciiBody {
 public:
  AsciiBody(const Input& input, const PlyHeader& header) : text_(input, header.size) {}

  double read(Scalar) { return text_.number("a number"); }
  std::size_t remaining() const { return text_.remaining() + 1; }
  static std::size_t smallest(Scalar) { return 2; }
  std::size_t place() const { return text_.offset(); }
  [[noreturn]] void fail(const std::string& what) const { text_.fail(what); }
  bool hasMore(std::size_t) { return !text_.atEnd(); }

 private:
  TextReader text_;
};

class BinaryBody {
 public:
  BinaryBody(const Input& input, const PlyHeader& header)
      : input_(input), order_(header.order), offset_(header.size) {}

  double read(Scalar type) {
    if (remaining() < sizeOf(type)) fail("truncated");
    const double value = loadScalar(input_.bytes(), offset_, type, order_);
    offset_ += sizeOf(type);
    return value;
  }
  std::size_t remaining() const { return input_.bytes().size() - offset_; }
  static std::size_t smallest(Scalar type) { return sizeOf(type); }
  static std::size_t place() { return NO_OFFSET; }
  [[noreturn]] void fail(const std::string& what) const { input_.fail(what); }
  bool hasMore(std::size_t record) const {
    return remaining() >= record && !isPadding(input_.bytes().substr(offset_));
  }

 private:
  const Input& input_;
  ByteOrder order_;
  std::size_t offset_;
};

/// Where the numbers of a vertex stand among its properties; -1: nowhere.
struct VertexLayout {
  explicit VertexLayout(const PlyElement& element)
      : position{element.find({"x"}), element.find({"y"}), element.find({"z"})},
        normal{element.find({"nx", "normal_x"}),
               element.find({"ny", "normal_y"}),
               element.find({"nz", "normal_z"})},
        color{element.find({"red", "diffuse_red", "r"}),
              element.find({"green", "diffuse_green", "g"}),
              element.find({"blue", "diffuse_blue", "b"})} {}

  static bool complete(const std::array<int, 3>& part) {
    return part[0] >= 0 && part[1] >= 0 && part[2] >= 0;
  }

  std::array<int, 3> position, normal, color;
};

template <class Body>
class PlyReader {
 public:
  PlyReader(const Input& input, const PlyHeader& header, Unseen unseen)
      : input_(input), header_(header), body_(input, header), builder_(input, unseen) {}

  MeshFile read() {
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements) {
      checkCount(element);
      if (element.name == "vertex") {
        has_vertices = true;
        readVertices(element);
      } else if (element.name == "face") {
        readLists(element, false);
      } else if (element.name == "tristrips") {
        readLists(element, true);
      } else {
        skip(element);
      }
    }
    if (!has_vertices) input_.fail("there is no element 'vertex' in it");
    checkEnd(header_.elements.back());
    return builder_.finish(color_range_);
  }

 private:
  void checkCount(const PlyElement& element) const {
    std::size_t smallest = 0;
    for (const PlyProperty& property : element.properties)
      smallest += Body::smallest(property.is_list ? property.count_type : property.type);
    if (smallest != 0 && element.count > body_.remaining() / smallest)
      input_.fail("truncated: its header says " + std::to_string(element.count) + " times " +
                  inQuotes(element.name) + ", too many for the size of the file");
  }

  /// What is shorter than a record of the last element, with a triangle for a list, is let pass.
  void checkEnd(const PlyElement& last) {
    std::size_t record = 0;
    for (const PlyProperty& property : last.properties)
      record += property.is_list ? sizeOf(property.count_type) + 3 * sizeOf(property.type)
                                 : sizeOf(property.type);
    if (body_.hasMore(record))
      body_.fail("more data than its header says, behind " + std::to_string(last.count) +
                 " times " + inQuotes(last.name));
  }

  void readVertices(const PlyElement& element) {
    const VertexLayout layout(element);
    if (!VertexLayout::complete(layout.position)) input_.fail("its vertices have no x, y and z");
    for (const auto& part : {layout.position, layout.normal, layout.color})
      for (int place : part)
        if (place >= 0 && element.properties[static_cast<std::size_t>(place)].is_list)
          input_.fail("a property of its vertices is a list where one number is due: " +
                      inQuotes(element.properties[static_cast<std::size_t>(place)].name));
    const bool normals = VertexLayout::complete(layout.normal);
    const bool colors = VertexLayout::complete(layout.color);
    double color_scale = 1;
    if (colors) {
      const Scalar type = element.properties[static_cast<std::size_t>(layout.color[0])].type;
      if (type == Scalar::FLOAT || type == Scalar::DOUBLE) color_range_ = ColorRange::UNIT;
      if (type == Scalar::UINT16) color_scale = 1.0 / 257;
    }
    builder_.reserve(element.count, 0);
    std::vector<double> values(element.properties.size());
    const auto at = [&](const std::array<int, 3>& part, int axis) {
      return values[static_cast<std::size_t>(part[static_cast<std::size_t>(axis)])];
    };
    for (std::size_t i = 0; i < element.count; ++i) {
      for (std::size_t p = 0; p < values.size(); ++p)
        values[p] = readProperty(element.properties[p]);
      builder_.place(body_.place());
      builder_.addVertex(at(layout.position, 0), at(layout.position, 1), at(layout.position, 2));
      if (normals)
        builder_.addNormal(at(layout.normal, 0), at(layout.normal, 1), at(layout.normal, 2));
      if (colors)
        builder_.addColor(color_scale * at(layout.color, 0),
                          color_scale * at(layout.color, 1),
                          color_scale * at(layout.color, 2));
    }
  }

  /// The value of a number; a list is put into list_.
  double readProperty(const PlyProperty& property) {
    if (!property.is_list) return body_.read(property.type);
    std::int64_t count = 0;
    if (!toWhole(body_.read(property.count_type), count) || count < 0)
      body_.fail("a list with a length that is none");
    if (static_cast<std::size_t>(count) > body_.remaining() / Body::smallest(property.type))
      body_.fail("truncated: a list is longer than the rest of the file");
    list_.resize(static_cast<std::size_t>(count));
    for (double& value : list_) value = body_.read(property.type);
    return 0;
  }

  void readLists(const PlyElement& element, bool strips) {
    const int place = element.find({"vertex_indices", "vertex_index"});
    if (place < 0 || !element.properties[static_cast<std::size_t>(place)].is_list) {
      if (element.count == 0) return;
      input_.fail("its faces have no list vertex_indices");
    }
    builder_.reserve(builder_.vertexCount(), strips ? 0 : element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      for (int p = 0; p < static_cast<int>(element.properties.size()); ++p) {
        readProperty(element.properties[static_cast<std::size_t>(p)]);
        if (p != place) continue;
        builder_.place(body_.place());
        toCorners();
        if (strips)
          builder_.addStrip(corners_);
        else
          builder_.addPolygon(corners_);
      }
    }
  }

  void toCorners() {
    corners_.resize(list_.size());
    for (std::size_t i = 0; i < list_.size(); ++i)
      if (!toWhole(list_[i], corners_[i])) body_.fail("a face index that is not a whole number");
  }

  void skip(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::size_t i = 0; i < element.count; ++i)
      for (const PlyProperty& property : element.properties) readProperty(property);
  }

  const Input& input_;
  const PlyHeader& header_;
  Body body_;
  MeshBuilder builder_;
  ColorRange color_range_ = ColorRange::BYTE;
  std::vector<double> list_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

MeshFile readPly(const Input& input, Unseen unseen) {
  const PlyHeader header = readPlyHeader(input);
  return header.ascii ? PlyReader<AsciiBody>(input, header, unseen).read()
                      : PlyReader<BinaryBody>(input, header, unseen).read();
}

}  // namespace posture
