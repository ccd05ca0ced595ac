// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "byte_order.h"
#include "mesh_builder.h"
#include "readers.h"
#include "text_reader.h"
#include <string>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Polygons one after the other: polygon i has corners[offsets[i]] to corners[offsets[i + 1]].
struct Cells {
  std::vector<std::int64_t> offsets, corners;

  std::size_t count() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::vector<std::int64_t> cell(std::size_t i) const {
    return {corners.begin() + offsets[i], corners.begin() + offsets[i + 1]};
  }
};

class VtkReader {
 public:
  VtkReader(const Input& input, Unseen unseen) : text_(input), builder_(input, unseen) {}

  MeshFile read() {
    readHeader();
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
      const std::string section = lowercase(word);
      if (section == "point_data" || section == "cell_data") break;
      readSection(section);
    }
    addUnstructuredCells();
    return builder_.finish();
  }

 private:
  void readHeader() {
    text_.skipLine();
    text_.skipLine();
    const std::string_view encoding = text_.word();
    binary_ = lowercase(encoding) == "binary";
    if (!binary_ && lowercase(encoding) != "ascii")
      text_.fail(inQuotes(encoding) + " where ASCII or BINARY is expected");
    std::string_view word = text_.word();
    if (lowercase(word) != "dataset") text_.fail(inQuotes(word) + " where DATASET is expected");
    word = text_.word();
    unstructured_ = lowercase(word) == "unstructured_grid";
    if (!unstructured_ && lowercase(word) != "polydata")
      text_.fail("DATASET " + inQuotes(word) + " is not a surface (POLYDATA, UNSTRUCTURED_GRID)");
    if (binary_) text_.nameNoLines();
  }

  void readSection(const std::string& section) {
    if (section == "points")
      readPoints();
    else if (section == "polygons")
      readPolygons(false);
    else if (section == "triangle_strips")
      readPolygons(true);
    else if (section == "vertices" || section == "lines")
      readCells();
    else if (section == "cells" && unstructured_)
      cells_ = readCells();
    else if (section == "cell_types" && unstructured_)
      cell_types_ =
          readWhole(text_.count(text_.word(), smallest(Scalar::INT32), "the number of cell types"),
                    Scalar::INT32);
    else if (section == "field")
      skipField();
    else if (section == "metadata")
      skipMetadata();
    else
      text_.fail(inQuotes(section) + " is not a VTK section");
  }

  void readPoints() {
    if (builder_.vertexCount() != 0) text_.fail("a second section POINTS");
    const std::string_view count_word = text_.word();
    const Scalar type = readType();
    const std::size_t count = text_.count(count_word, 3 * smallest(type), "the number of points");
    const std::vector<double> values = readNumbers(3 * count, type);
    builder_.reserve(count, 0);
    for (std::size_t i = 0; i < values.size(); i += 3)
      builder_.addVertex(values[i], values[i + 1], values[i + 2]);
  }

  void readPolygons(bool strips) {
    const Cells cells = readCells();
    for (std::size_t i = 0; i < cells.count(); ++i)
      if (strips)
        builder_.addStrip(cells.cell(i));
      else
        builder_.addPolygon(cells.cell(i));
  }

  /// Behind the keyword: the number of polygons and of all numbers, each polygon led by its length;
  /// since version 5 instead the number of offsets and of corners, and one array of each.
  Cells readCells() {
    const std::size_t item = smallest(Scalar::INT32);
    const std::size_t first = text_.count(text_.word(), item, "the number of cells");
    const std::size_t second = text_.count(text_.word(), item, "the size of the cells");
    const std::size_t before = text_.offset();
    const bool has_offsets = text_.word() == "OFFSETS";
    if (!has_offsets) text_.moveTo(before);
    return has_offsets ? readOffsetCells(first, second) : readClassicCells(first, second);
  }

  Cells readOffsetCells(std::size_t offset_count, std::size_t corner_count) {
    Cells cells;
    cells.offsets = readWhole(offset_count, readType());
    const std::string_view word = text_.word();
    if (word != "CONNECTIVITY") text_.fail(inQuotes(word) + " where CONNECTIVITY is expected");
    cells.corners = readWhole(corner_count, readType());
    if (!cells.offsets.empty() && cells.offsets.front() != 0)
      text_.fail("the offsets of the polygons begin at " + std::to_string(cells.offsets.front()) +
                 ", not at 0");
    std::int64_t last = 0;
    for (const std::int64_t offset : cells.offsets) {
      if (offset < last || offset > static_cast<std::int64_t>(cells.corners.size()))
        text_.fail("an offset of a polygon is out of range: " + std::to_string(offset));
      last = offset;
    }
    if (last != static_cast<std::int64_t>(corner_count))
      text_.fail("the offsets of the polygons end at " + std::to_string(last) + ", not at " +
                 std::to_string(corner_count));
    return cells;
  }

  Cells readClassicCells(std::size_t count, std::size_t size) {
    const std::vector<std::int64_t> values = readWhole(size, Scalar::INT32);
    Cells cells;
    cells.offsets.push_back(0);
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (at >= size || values[at] < 0 || static_cast<std::size_t>(values[at]) >= size - at)
        failSizes(size);
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      cells.corners.insert(cells.corners.end(), begin, begin + values[at]);
      cells.offsets.push_back(static_cast<std::int64_t>(cells.corners.size()));
      at += 1 + static_cast<std::size_t>(values[at]);
    }
    if (at != size) failSizes(size);
    return cells;
  }

  [[noreturn]] void failSizes(std::size_t size) const {
    text_.fail("the sizes of the polygons do not add up to " + std::to_string(size));
  }

  void addUnstructuredCells() {
    if (cells_.count() != cell_types_.size())
      text_.fail("truncated: " + std::to_string(cells_.count()) + " cells, " +
                 std::to_string(cell_types_.size()) + " cell types");
    enum : std::int64_t { POLY_LINE = 4, TRIANGLE, STRIP, POLYGON, PIXEL, QUAD };
    for (std::size_t i = 0; i < cells_.count(); ++i) {
      std::vector<std::int64_t> corners = cells_.cell(i);
      const std::int64_t type = cell_types_[i];
      if (type == PIXEL && corners.size() == 4) std::swap(corners[2], corners[3]);
      if (type == STRIP)
        builder_.addStrip(corners);
      else if (type >= TRIANGLE && type <= QUAD)
        builder_.addPolygon(corners);
      else if (type < 0 || type > POLY_LINE)
        text_.fail("cell " + std::to_string(i) + " has type " + std::to_string(type) +
                   ", which is not a polygon");
    }
  }

  /// Arrays that are named, but do not matter here: name, components, tuples, type, numbers.
  void skipField() {
    text_.word();
    const std::size_t arrays = text_.count(text_.word(), 1, "the number of arrays");
    for (std::size_t i = 0; i < arrays;) {
      const std::string_view name = text_.word();
      if (lowercase(name) == "metadata") {
        skipMetadata();
        continue;
      }
      const std::size_t components = text_.count(text_.word(), 1, "the number of components");
      const std::size_t tuples = text_.count(text_.word(), 1, "the number of tuples");
      if (components != 0 && tuples > (text_.remaining() + 1) / components)
        text_.fail("truncated inside the field array " + inQuotes(name));
      skipArray(components * tuples);
      ++i;
    }
  }

  /// Behind its sizes: the type, then the values.
  void skipArray(std::size_t count) {
    const std::size_t before = text_.offset();
    if (lowercase(text_.word()) == "string") {
      text_.skipLine();
      for (std::size_t i = 0; i < count; ++i) skipString();
    } else {
      text_.moveTo(before);
      readNumbers(count, readType());
    }
  }

  /// A line; of a binary file its length, of which the first two bits say how many bytes it has,
  /// and as many characters.
  void skipString() {
    if (text_.remaining() == 0) text_.fail("truncated inside an array of strings");
    if (!binary_) return text_.skipLine();
    const auto byte = [&] {
      if (text_.remaining() == 0) text_.fail("truncated inside an array of strings");
      return static_cast<std::uint8_t>(text_.bytes(1).front());
    };
    const std::uint8_t first = byte();
    constexpr int MORE[] = {7, 3, 1, 0};
    std::uint64_t length = first & 0x3f;
    for (int i = 0; i < MORE[first >> 6]; ++i) length = length << 8 | byte();
    if (length > text_.remaining()) text_.fail("truncated inside an array of strings");
    text_.bytes(static_cast<std::size_t>(length));
  }

  /// Ends with an empty line.
  void skipMetadata() {
    text_.skipLine();
    while (!text_.wordOnLine().empty()) text_.skipLine();
  }

  Scalar readType() {
    static const std::pair<std::string_view, Scalar> TYPES[] = {{"char", Scalar::INT8},
                                                                {"signed_char", Scalar::INT8},
                                                                {"unsigned_char", Scalar::UINT8},
                                                                {"short", Scalar::INT16},
                                                                {"unsigned_short", Scalar::UINT16},
                                                                {"int", Scalar::INT32},
                                                                {"vtkidtype", Scalar::INT32},
                                                                {"vtktypeint32", Scalar::INT32},
                                                                {"unsigned_int", Scalar::UINT32},
                                                                {"long", Scalar::INT64},
                                                                {"vtktypeint64", Scalar::INT64},
                                                                {"unsigned_long", Scalar::UINT64},
                                                                {"vtktypeuint64", Scalar::UINT64},
                                                                {"float", Scalar::FLOAT},
                                                                {"double", Scalar::DOUBLE}};
    const std::string_view word = text_.word();
    for (const auto& [name, type] : TYPES)
      if (lowercase(word) == name) return type;
    text_.fail("unknown number type " + inQuotes(word));
  }

  std::size_t smallest(Scalar type) const { return binary_ ? sizeOf(type) : 2; }

  std::vector<double> readNumbers(std::size_t count, Scalar type) {
    if (binary_) text_.skipLine();
    if (count > (text_.remaining() + (binary_ ? 0 : 1)) / smallest(type))
      text_.fail("truncated inside an array of numbers");
    std::vector<double> values(count);
    if (binary_) {
      const std::string_view bytes = text_.bytes(count * sizeOf(type));
      for (std::size_t i = 0; i < count; ++i)
        values[i] = loadScalar(bytes, i * sizeOf(type), type, ByteOrder::BIG);
    } else {
      for (double& value : values) value = text_.number("a number");
    }
    return values;
  }

  std::vector<std::int64_t> readWhole(std::size_t count, Scalar type) {
    const std::vector<double> values = readNumbers(count, type);
    std::vector<std::int64_t> whole(count);
    for (std::size_t i = 0; i < count; ++i)
      if (!toWhole(values[i], whole[i])) text_.fail("an index that is not a whole number");
    return whole;
  }

  TextReader text_;
  MeshBuilder builder_;
  bool binary_ = false, unstructured_ = false;
  Cells cells_;
  std::vector<std::int64_t> cell_types_;
};

}  // namespace

MeshFile readVtk(const Input& input, Unseen unseen) { return VtkReader(input, unseen).read(); }

}  // namespace posture
