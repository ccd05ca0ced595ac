// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "byte_order.h"
#include "mesh_builder.h"
#include "readers.h"
#include "text.h"
#include "text_reader.h"
#include <string>
#include <vector>

namespace posture {
namespace {

constexpr std::size_t HEAD_SIZE = 80, FACET_SIZE = 50;

class AsciiStlReader {
 public:
  explicit AsciiStlReader(const Input& input) : text_(input), builder_(input, Unseen::REFUSED) {}

  MeshFile read() {
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
      if (lowercase(word) != "solid") text_.fail(inQuotes(word) + " where 'solid' is expected");
      text_.skipLine();
      while (readFacet()) continue;
      text_.skipLine();
    }
    return builder_.finish();
  }

 private:
  /// False at the solid's end.
  bool readFacet() {
    const std::string_view word = text_.word();
    if (lowercase(word) == "endsolid") return false;
    if (word.empty()) text_.fail("truncated: no 'endsolid'");
    if (lowercase(word) != "facet") text_.fail(inQuotes(word) + " where 'facet' is expected");
    // The normal follows from the corners; some programs write nan there.
    text_.skipLine();
    expect("outer");
    expect("loop");
    corners_.clear();
    while (readCorner()) continue;
    if (corners_.size() < 3)
      text_.fail("a facet of " + std::to_string(corners_.size()) + " vertices (truncated?)");
    expect("endfacet");
    builder_.addPolygon(corners_);
    return true;
  }

  bool readCorner() {
    const std::string_view word = text_.word();
    if (lowercase(word) == "endloop") return false;
    if (word.empty()) text_.fail("truncated inside a facet");
    if (lowercase(word) != "vertex") text_.fail(inQuotes(word) + " where 'vertex' is expected");
    builder_.place(text_.offset());
    corners_.push_back(static_cast<std::int64_t>(builder_.vertexCount()));
    const double x = coordinate(), y = coordinate(), z = coordinate();
    builder_.addVertex(x, y, z);
    return true;
  }

  double coordinate() { return text_.number("a vertex coordinate"); }

  void expect(const char* keyword) {
    const std::string_view word = text_.word();
    if (word.empty()) text_.fail("truncated inside a facet");
    if (lowercase(word) != keyword)
      text_.fail(inQuotes(word) + " where '" + keyword + "' is expected");
  }

  TextReader text_;
  MeshBuilder builder_;
  std::vector<std::int64_t> corners_;
};

MeshFile readBinaryStl(const Input& input) {
  const std::string_view bytes = input.bytes();
  if (bytes.size() < HEAD_SIZE + 4)
    input.fail("truncated: shorter than the head of a binary STL file");
  const auto facets = loadNumber<std::uint32_t>(bytes, HEAD_SIZE, ByteOrder::LITTLE);
  const std::size_t whole_facets = (bytes.size() - HEAD_SIZE - 4) / FACET_SIZE;
  if (facets > whole_facets)
    input.fail("truncated: its head says " + std::to_string(facets) + " facets, there are " +
               std::to_string(whole_facets));
  if (facets < whole_facets && !isPadding(bytes.substr(HEAD_SIZE + 4 + facets * FACET_SIZE)))
    input.fail("its head says " + std::to_string(facets) + " facets, there are " +
               std::to_string(whole_facets));
  MeshBuilder builder(input, Unseen::REFUSED);
  builder.reserve(std::size_t{3} * facets, facets);
  std::vector<std::int64_t> corners(3);
  for (std::size_t facet = 0; facet < facets; ++facet) {
    std::size_t offset = HEAD_SIZE + 4 + facet * FACET_SIZE + 12;
    for (std::int64_t& corner : corners) {
      corner = static_cast<std::int64_t>(builder.vertexCount());
      builder.addVertex(loadNumber<float>(bytes, offset, ByteOrder::LITTLE),
                        loadNumber<float>(bytes, offset + 4, ByteOrder::LITTLE),
                        loadNumber<float>(bytes, offset + 8, ByteOrder::LITTLE));
      offset += 12;
    }
    builder.addPolygon(corners);
  }
  return builder.finish();
}

bool isAsciiStl(std::string_view bytes) {
  bytes.remove_prefix(textBegin(bytes));
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  const std::string_view head = bytes.substr(0, 1024);
  return lowercase(head.substr(0, 5)) == "solid" && head.find('\0') == std::string_view::npos;
}

}  // namespace

bool isBinaryStl(std::string_view bytes) {
  return bytes.size() > HEAD_SIZE + 4 &&
         bytes.size() == HEAD_SIZE + 4 +
                             FACET_SIZE * std::size_t{loadNumber<std::uint32_t>(
                                              bytes, HEAD_SIZE, ByteOrder::LITTLE)};
}

MeshFile readStl(const Input& input) {
  const bool ascii = !isBinaryStl(input.bytes()) && isAsciiStl(input.bytes());
  return ascii ? AsciiStlReader(input).read() : readBinaryStl(input);
}

}  // namespace posture
