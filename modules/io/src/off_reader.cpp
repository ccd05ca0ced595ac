// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_builder.h"
#include "readers.h"
#include "text_reader.h"
#include <string>
#include <vector>

namespace posture {
namespace {

struct OffHeader {
  bool colors = false, normals = false, texture = false;
  /// MeshLab's NCOFF has the colour before the normal, Geomview's CNOFF behind it.
  bool colors_first = false;
};

/// As Geomview writes it; some programs write all of it in small letters.
std::string keyword(std::string_view word) {
  std::string capitals(word);
  if (lowercase(word) == word)
    for (char& c : capitals)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return capitals;
}

/// Splits the letters before OFF; false where they are none that belong there.
bool parseKeyword(std::string_view given, OffHeader& header) {
  const std::string capitals = keyword(given);
  const std::string_view word = capitals;
  if (word.size() < 3 || word.substr(word.size() - 3) != "OFF") return false;
  for (std::string_view rest = word.substr(0, word.size() - 3); !rest.empty();) {
    const bool texture = rest.substr(0, 2) == "ST";
    if (!texture && std::string_view("CN4n").find(rest[0]) == std::string_view::npos) return false;
    header.colors_first = header.colors_first || (rest[0] == 'C' && header.normals);
    header.texture = header.texture || texture;
    header.colors = header.colors || rest[0] == 'C';
    header.normals = header.normals || rest[0] == 'N';
    rest.remove_prefix(texture ? 2 : 1);
  }
  return true;
}

class OffReader {
 public:
  OffReader(const Input& input, Unseen unseen) : text_(input, 0, '#'), builder_(input, unseen) {}

  MeshFile read() {
    readKeyword();
    std::string_view word = text_.wordOnLine();
    if (word.empty()) word = text_.word();
    constexpr std::size_t SMALLEST_VERTEX = 6, SMALLEST_FACE = 2;
    const std::size_t vertices = text_.count(word, SMALLEST_VERTEX, "the number of vertices");
    const std::size_t faces = text_.count(text_.word(), SMALLEST_FACE, "the number of faces");
    builder_.reserve(vertices, faces);
    for (std::size_t i = 0; i < vertices; ++i) readVertex(i, vertices);
    for (std::size_t i = 0; i < faces; ++i) readFace(i, faces);
    if (text_.nextLine() && !text_.atEnd())
      text_.fail("more than the " + std::to_string(vertices) + " vertices and " +
                 std::to_string(faces) + " faces that it says");
    return builder_.finish(integer_colors_ ? ColorRange::BYTE : ColorRange::UNIT);
  }

 private:
  /// Of a file with the ending it may be missing.
  void readKeyword() {
    const std::size_t before = text_.offset();
    const std::string_view word = text_.word();
    std::int64_t count = 0;
    if (parseInteger(word, count)) return text_.moveTo(before);
    if (!parseKeyword(word, header_)) text_.fail(inQuotes(word) + " where OFF is expected");
    if (keyword(word).find_first_of("4n") != std::string::npos)
      text_.fail(std::string(word) + ": only three coordinates a vertex can be read");
    const std::size_t after = text_.offset();
    if (lowercase(text_.wordOnLine()) == "binary") text_.fail("binary OFF cannot be read");
    text_.moveTo(after);
  }

  void nextLine(const char* what, std::size_t number, std::size_t all) {
    if (!text_.nextLine())
      text_.fail("truncated: " + std::to_string(number) + " of " + std::to_string(all) + " " +
                 what);
    builder_.place(text_.offset());
  }

  void readVertex(std::size_t number, std::size_t all) {
    nextLine("vertices", number, all);
    const double x = coordinate(), y = coordinate(), z = coordinate();
    builder_.addVertex(x, y, z);
    if (header_.colors || header_.normals) {
      words_.clear();
      for (std::string_view w = text_.wordOnLine(); !w.empty(); w = text_.wordOnLine())
        words_.push_back(w);
      readExtras();
    }
  }

  double coordinate() { return text_.number(text_.wordOnLine(), "a vertex coordinate"); }

  /// A colour has three numbers or four: what the others leave on the line.
  void readExtras() {
    const std::size_t others = (header_.normals ? 3u : 0u) + (header_.texture ? 2u : 0u);
    if (words_.size() < others) text_.fail("a vertex with too few numbers (truncated?)");
    const std::size_t color_words = header_.colors ? words_.size() - others : 0;
    if (header_.colors && color_words != 3 && color_words != 4)
      text_.fail("a vertex colour of " + std::to_string(color_words) + " numbers");
    if (header_.colors) readColor(header_.colors_first || !header_.normals ? 0 : 3);
    if (header_.normals) {
      const std::size_t at = header_.colors_first ? color_words : 0;
      builder_.addNormal(extra(at), extra(at + 1), extra(at + 2));
    }
  }

  void readColor(std::size_t at) {
    for (std::size_t i = at; i < at + 3; ++i)
      if (words_[i].find('.') != std::string_view::npos) integer_colors_ = false;
    builder_.addColor(extra(at), extra(at + 1), extra(at + 2));
  }

  double extra(std::size_t at) const { return text_.number(words_[at], "a vertex"); }

  void readFace(std::size_t number, std::size_t all) {
    nextLine("faces", number, all);
    const std::size_t count = text_.count(text_.wordOnLine(), 2, "the number of corners");
    corners_.clear();
    for (std::size_t i = 0; i < count; ++i)
      corners_.push_back(text_.integer(text_.wordOnLine(), "a face index"));
    builder_.addPolygon(corners_);
  }

  TextReader text_;
  MeshBuilder builder_;
  OffHeader header_;
  bool integer_colors_ = true;
  std::vector<std::string_view> words_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

bool isOffKeyword(std::string_view word) {
  OffHeader header;
  return parseKeyword(word, header);
}

MeshFile readOff(const Input& input, Unseen unseen) { return OffReader(input, unseen).read(); }

}  // namespace posture
