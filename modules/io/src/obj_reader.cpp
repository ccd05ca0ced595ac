// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_builder.h"
#include "readers.h"
#include "text_reader.h"
#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace posture {
namespace {

// The statements that say nothing about polygons.
constexpr std::string_view IGNORED[] = {
    "vt",       "vp",       "g",      "o",          "s",         "mg",    "l",     "p",    "usemtl",
    "mtllib",   "usemap",   "maplib", "cstype",     "deg",       "bmat",  "step",  "curv", "curv2",
    "surf",     "parm",     "trim",   "hole",       "scrv",      "sp",    "end",   "con",  "bevel",
    "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj", "ctech", "stech", "call", "csh",
    "bsp",      "bzp",      "cdc",    "cdp",        "res"};

class ObjReader {
 public:
  ObjReader(const Input& input, Unseen unseen) : text_(input, 0, '#'), builder_(input, unseen, 1) {}

  MeshFile read() {
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
      builder_.place(text_.offset());
      if (word == "v")
        readVertex();
      else if (word == "vn")
        readNormal();
      else if (word == "f" || word == "fo")
        readFace();
      else if (std::find(std::begin(IGNORED), std::end(IGNORED), word) != std::end(IGNORED))
        skipStatement();
      else
        text_.fail(inQuotes(word) + " is not an OBJ statement");
    }
    builder_.setNormals(normalsOfVertices());
    return builder_.finish(ColorRange::UNIT);
  }

 private:
  /// The next word of a statement, which goes on behind a backslash at the end of its line.
  std::string_view next() {
    std::string_view word = text_.wordOnLine();
    while (!word.empty() && word.back() == '\\' && text_.isAtLineEnd()) {
      word.remove_suffix(1);
      text_.skipLine();
      if (word.empty()) word = text_.wordOnLine();
    }
    return word;
  }

  void skipStatement() {
    while (!next().empty()) continue;
  }

  void readVertex() {
    std::array<double, 7> v{};
    std::size_t count = 0;
    for (std::string_view word = next(); !word.empty(); word = next()) {
      if (count == v.size()) text_.fail("a vertex of more than 7 numbers");
      v[count++] = text_.number(word, "a vertex");
    }
    if (count < 3) text_.fail("a vertex of " + std::to_string(count) + " numbers (truncated?)");
    if (count == 5) text_.fail("a vertex of 5 numbers");
    builder_.addVertex(v[0], v[1], v[2]);
    if (count >= 6) builder_.addColor(v[3], v[4], v[5]);
  }

  void readNormal() {
    for (int i = 0; i < 3; ++i) normals_.push_back(text_.number(next(), "a normal"));
  }

  /// From the file's number, 1-based or counted back from the newest one.
  std::int64_t resolve(std::string_view word, std::size_t known) const {
    const std::int64_t number = text_.integer(word, "a face index");
    if (number == 0) text_.fail("face index 0, OBJ counts from 1");
    if (number > 0) return number - 1;
    if (number < -static_cast<std::int64_t>(known))
      text_.fail("face index " + std::to_string(number) + " is out of range, there are " +
                 std::to_string(known) + " vertices before it");
    return number + static_cast<std::int64_t>(known);
  }

  void readFace() {
    corners_.clear();
    for (std::string_view word = next(); !word.empty(); word = next()) {
      const std::size_t slash = word.find('/');
      corners_.push_back(resolve(word.substr(0, slash), builder_.vertexCount()));
      if (slash == std::string_view::npos) continue;
      const std::size_t second = word.find('/', slash + 1);
      if (second == std::string_view::npos || second + 1 == word.size()) continue;
      noteNormal(corners_.back(), resolve(word.substr(second + 1), normals_.size() / 3));
    }
    // A line without an end may have been cut off; elsewhere faces of two corners are edges.
    if (corners_.size() < 3 && text_.remaining() == 0)
      text_.fail("a face of " + std::to_string(corners_.size()) + " corners (truncated?)");
    builder_.addPolygon(corners_);
  }

  /// The first normal that a face gives a vertex is the vertex's.
  void noteNormal(std::int64_t vertex, std::int64_t normal) {
    if (vertex >= static_cast<std::int64_t>(builder_.vertexCount())) return;
    normal_of_vertex_.resize(builder_.vertexCount(), -1);
    std::int64_t& known = normal_of_vertex_[static_cast<std::size_t>(vertex)];
    if (known < 0) known = normal;
  }

  /// As the faces say; where they say nothing, one by one in the order of the vertices.
  std::vector<double> normalsOfVertices() const {
    if (normal_of_vertex_.empty()) return normals_;
    if (normal_of_vertex_.size() != builder_.vertexCount()) return {};
    std::vector<double> normals;
    normals.reserve(3 * normal_of_vertex_.size());
    for (const std::int64_t normal : normal_of_vertex_) {
      if (normal < 0 || static_cast<std::size_t>(normal) >= normals_.size() / 3) return {};
      const auto row = 3 * static_cast<std::size_t>(normal);
      normals.insert(normals.end(), {normals_[row], normals_[row + 1], normals_[row + 2]});
    }
    return normals;
  }

  TextReader text_;
  MeshBuilder builder_;
  std::vector<double> normals_;
  std::vector<std::int64_t> normal_of_vertex_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

MeshFile readObj(const Input& input, Unseen unseen) { return ObjReader(input, unseen).read(); }

}  // namespace posture
