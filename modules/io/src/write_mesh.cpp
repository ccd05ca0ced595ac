// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/atomic_file.h>
#include <posture/io/mesh_io.h>

#include "byte_order.h"
#include "input.h"
#include "single_precision.h"
#include "text_reader.h"
#include "text_writer.h"
#include <string>

namespace posture {
namespace {

std::string toPly(const TriangleMesh& mesh, const Colors& colors) {
  const bool floats = fitFloats(mesh.vertices) && differAsFloats(mesh.vertices);
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  appendNumber(out, mesh.vertices.rows());
  out += floats ? "\nproperty float x\nproperty float y\nproperty float z\n"
                : "\nproperty double x\nproperty double y\nproperty double z\n";
  if (colors.rows() != 0) out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  out += "element face ";
  appendNumber(out, mesh.faces.rows());
  out += "\nproperty list uchar int vertex_indices\nend_header\n";
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    for (int axis = 0; axis < 3; ++axis) appendReal(out, mesh.vertices(v, axis), floats);
    for (int c = 0; c < 3 && colors.rows() != 0; ++c) out += static_cast<char>(colors(v, c));
  }
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    out += '\3';
    for (int corner = 0; corner < 3; ++corner)
      appendLittle<std::int32_t>(out, mesh.faces(f, corner));
  }
  return out;
}

/// Colours behind the position from 0 to 1, as most readers of this extension expect them.
std::string toObj(const TriangleMesh& mesh, const Colors& colors) {
  std::string out;
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    out += "v ";
    appendNumbers(out, ' ', mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2));
    for (int c = 0; c < 3 && colors.rows() != 0; ++c) {
      out += ' ';
      appendNumber(out, static_cast<float>(colors(v, c)) / 255.0f);
    }
    out += '\n';
  }
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    out += "f ";
    appendNumbers(out, ' ', mesh.faces(f, 0) + 1, mesh.faces(f, 1) + 1, mesh.faces(f, 2) + 1);
    out += '\n';
  }
  return out;
}

std::string toOff(const TriangleMesh& mesh, const Colors& colors) {
  std::string out = colors.rows() != 0 ? "COFF\n" : "OFF\n";
  appendNumbers(out, ' ', mesh.vertices.rows(), mesh.faces.rows(), 0);
  out += '\n';
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    appendNumbers(out, ' ', mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2));
    if (colors.rows() != 0) {
      out += ' ';
      appendNumbers(out, ' ', int{colors(v, 0)}, int{colors(v, 1)}, int{colors(v, 2)}, 255);
    }
    out += '\n';
  }
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    appendNumbers(out, ' ', 3, mesh.faces(f, 0), mesh.faces(f, 1), mesh.faces(f, 2));
    out += '\n';
  }
  return out;
}

std::string toText(const std::filesystem::path& path,
                   const TriangleMesh& mesh,
                   const Colors& colors) {
  const std::string ending = lowercase(path.extension().string());
  if (ending == ".ply") return toPly(mesh, colors);
  if (ending == ".obj") return toObj(mesh, colors);
  if (ending == ".off") return toOff(mesh, colors);
  throw std::invalid_argument(onOneLine(path.string()) +
                              ": a mesh is written to .ply, .obj or .off");
}

}  // namespace

void writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh, const Colors& colors) {
  require(colors.rows() == 0 || colors.rows() == mesh.vertices.rows(),
          std::to_string(colors.rows()) + " colors for " + std::to_string(mesh.vertices.rows()) +
              " vertices");
  writeFile(path, toText(path, mesh, colors));
}

}  // namespace posture
