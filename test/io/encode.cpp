// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/encode.h"

#include <functional>
#include <sstream>

namespace posture::test {
namespace {

using Numbers = std::vector<double>;
using Encode = std::function<std::string(const Numbers&, bool is_index)>;

Numbers row(const TriangleMesh& mesh, Eigen::Index v) {
  return {mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2)};
}

Numbers face(const TriangleMesh& mesh, Eigen::Index f, bool with_count, int base = 0) {
  Numbers numbers;
  if (with_count) numbers.push_back(3);
  for (int c = 0; c < 3; ++c) numbers.push_back(mesh.faces(f, c) + base);
  return numbers;
}

std::string text(const Numbers& numbers) {
  std::ostringstream out;
  out.precision(17);
  for (const double n : numbers) out << (out.tellp() == 0 ? "" : " ") << n;
  out << '\n';
  return out.str();
}

template <class T>
std::string packed(const Numbers& numbers, bool big_endian) {
  std::string bytes;
  for (const double n : numbers) bytes += raw(static_cast<T>(n), big_endian);
  return bytes;
}

std::string counts(const TriangleMesh& mesh) {
  return std::to_string(mesh.vertices.rows()) + " " + std::to_string(mesh.faces.rows());
}

std::string obj(const TriangleMesh& mesh) {
  std::string out = "# a comment\n";
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) out += "v " + text(row(mesh, v));
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) out += "f " + text(face(mesh, f, false, 1));
  return out;
}

std::string off(const TriangleMesh& mesh) {
  std::string out = "OFF\n" + counts(mesh) + " 0\n";
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) out += text(row(mesh, v));
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) out += text(face(mesh, f, true));
  return out;
}

std::string ply(const TriangleMesh& mesh, const std::string& format, const std::string& type) {
  std::string out = "ply\nformat " + format + " 1.0\nelement vertex " +
                    std::to_string(mesh.vertices.rows()) + "\n";
  for (const char* axis : {"x", "y", "z"}) out += "property " + type + " " + axis + "\n";
  out += "element face " + std::to_string(mesh.faces.rows()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
  const bool big = format == "binary_big_endian";
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v)
    out += format == "ascii" ? text(row(mesh, v))
           : type == "float" ? packed<float>(row(mesh, v), big)
                             : packed<double>(row(mesh, v), big);
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f)
    out += format == "ascii" ? text(face(mesh, f, true))
                             : '\3' + packed<int>(face(mesh, f, false), big);
  return out;
}

std::string asciiStl(const TriangleMesh& mesh) {
  std::string out = "solid a name\n";
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    out += "  facet normal 0 0 nan\n    outer loop\n";
    for (int c = 0; c < 3; ++c) out += "      vertex " + text(row(mesh, mesh.faces(f, c)));
    out += "    endloop\n  endfacet\n";
  }
  return out + "endsolid a name\n";
}

/// Classic cells: all numbers in one list, each polygon led by its length.
std::string classicCells(const TriangleMesh& mesh, const Encode& encode) {
  Numbers cells;
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f)
    for (const double n : face(mesh, f, true)) cells.push_back(n);
  return std::to_string(mesh.faces.rows()) + " " + std::to_string(cells.size()) + "\n" +
         encode(cells, true) + "\n";
}

/// The cells of VTK 5.x files: offsets and corners apart.
std::string offsetCells(const TriangleMesh& mesh, const Encode& encode) {
  Numbers offsets = {0}, corners;
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    for (const double n : face(mesh, f, false)) corners.push_back(n);
    offsets.push_back(static_cast<double>(corners.size()));
  }
  return std::to_string(offsets.size()) + " " + std::to_string(corners.size()) +
         "\nOFFSETS vtktypeint64\n" + encode(offsets, true) + "\nCONNECTIVITY vtktypeint64\n" +
         encode(corners, true) + "\n";
}

std::string vtk(const TriangleMesh& mesh, bool binary, bool offsets, bool unstructured) {
  const Encode encode = [=](const Numbers& numbers, bool is_index) {
    if (!binary) return text(numbers);
    if (!is_index) return packed<double>(numbers, true);
    return offsets ? packed<long long>(numbers, true) : packed<int>(numbers, true);
  };
  Numbers coordinates;
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v)
    for (const double n : row(mesh, v)) coordinates.push_back(n);
  std::string out = std::string("# vtk DataFile Version ") + (offsets ? "5.1" : "3.0") +
                    "\na title\n" + (binary ? "BINARY" : "ASCII") + "\nDATASET " +
                    (unstructured ? "UNSTRUCTURED_GRID" : "POLYDATA") + "\nPOINTS " +
                    std::to_string(mesh.vertices.rows()) + " double\n" +
                    encode(coordinates, false) + "\nMETADATA\nINFORMATION 0\n\n" +
                    (unstructured ? "CELLS " : "POLYGONS ");
  out += offsets ? offsetCells(mesh, encode) : classicCells(mesh, encode);
  if (unstructured) {
    const Numbers types(static_cast<std::size_t>(mesh.faces.rows()), 5);
    out += "CELL_TYPES " + std::to_string(types.size()) + "\n" +
           (binary ? packed<int>(types, true) : text(types)) + "\n";
  }
  return out + "POINT_DATA " + std::to_string(mesh.vertices.rows()) + "\n";
}

}  // namespace

std::string binaryStl(const TriangleMesh& mesh, const std::string& title) {
  std::string out = title;
  out.resize(80, ' ');
  out += raw(static_cast<std::uint32_t>(mesh.faces.rows()));
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    out += packed<float>({0, 0, 0}, false);
    for (int c = 0; c < 3; ++c) out += packed<float>(row(mesh, mesh.faces(f, c)), false);
    out += std::string(2, '\0');
  }
  return out;
}

std::vector<EncodedMesh> encodeEveryWay(const TriangleMesh& mesh) {
  std::vector<EncodedMesh> files = {{"mesh.obj", obj(mesh)},
                                    {"mesh.off", off(mesh)},
                                    {"ascii.stl", asciiStl(mesh)},
                                    {"binary.stl", binaryStl(mesh, "a title")},
                                    {"solid.stl", binaryStl(mesh, "solid but binary")}};
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const char* type : {"float", "double"})
      files.push_back({std::string(format) + "-" + type + ".ply", ply(mesh, format, type)});
  for (const bool binary : {false, true})
    for (const bool offsets : {false, true})
      for (const bool unstructured : {false, true})
        files.push_back({std::string(binary ? "binary" : "ascii") + (offsets ? "-5" : "-3") +
                             (unstructured ? "-grid" : "-poly") + ".vtk",
                         vtk(mesh, binary, offsets, unstructured)});
  return files;
}

std::string damage(std::string bytes, Rng& rng) {
  const auto place = [&] {
    return static_cast<std::size_t>(rng.below(static_cast<int>(bytes.size())));
  };
  const int kind = rng.below(5);
  if (kind == 0) bytes.resize(1 + place());
  for (int i = rng.below(4); kind != 0 && i >= 0; --i) {
    const std::size_t at = place();
    if (kind == 1) bytes[at] = static_cast<char>(rng.below(256));
    if (kind == 2) bytes[at] = static_cast<char>(bytes[at] ^ 1 << rng.below(8));
    if (kind == 3) bytes.insert(at, bytes.substr(place(), 1 + place() % 40));
    if (kind == 4) bytes[at] = "0123456789-. \n#"[rng.below(15)];
  }
  return bytes;
}

}  // namespace posture::test
