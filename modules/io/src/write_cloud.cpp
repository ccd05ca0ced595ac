// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/atomic_file.h>
#include <posture/io/shape_io.h>

#include "byte_order.h"
#include "input.h"
#include "single_precision.h"
#include "text_reader.h"
#include "text_writer.h"
#include <initializer_list>
#include <string>

namespace posture {
namespace {

/// `word` once for each column: three of positions, and of normals and colours where there are.
std::string perColumn(const PointCloud& cloud,
                      const std::string& position,
                      const std::string& normal,
                      const std::string& color) {
  return position + (cloud.normals.rows() != 0 ? normal : "") +
         (cloud.colors.rows() != 0 ? color : "");
}

std::string pcdHeader(const PointCloud& cloud, bool floats) {
  const auto points = cloud.points.rows();
  const auto width = cloud.width > 0 ? Eigen::Index{cloud.width} : points;
  std::string out = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" +
                    perColumn(cloud, " x y z", " normal_x normal_y normal_z", " rgb") + "\nSIZE" +
                    perColumn(cloud, floats ? " 4 4 4" : " 8 8 8", " 4 4 4", " 4") + "\nTYPE" +
                    perColumn(cloud, " F F F", " F F F", " F") + "\nCOUNT" +
                    perColumn(cloud, " 1 1 1", " 1 1 1", " 1") + "\nWIDTH ";
  appendNumber(out, width);
  out += "\nHEIGHT ";
  appendNumber(out, points / width);
  const Eigen::Vector3d sensor = cloud.sensor.value_or(Eigen::Vector3d::Zero());
  out += "\nVIEWPOINT ";
  appendNumbers(out, ' ', sensor[0], sensor[1], sensor[2]);
  out += " 1 0 0 0\nPOINTS ";
  appendNumber(out, points);
  return out + "\nDATA binary\n";
}

void appendRow(std::string& out, const Colors& colors, Eigen::Index row) {
  for (int c = 0; c < 3; ++c) out += static_cast<char>(colors(row, c));
}

void appendRow(std::string& out, const Points& points, Eigen::Index row, bool as_floats) {
  for (int axis = 0; axis < 3; ++axis) appendReal(out, points(row, axis), as_floats);
}

std::string toPcd(const PointCloud& cloud) {
  const bool floats = fitFloats(cloud.points);
  std::string out = pcdHeader(cloud, floats);
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    appendRow(out, cloud.points, i, floats);
    if (cloud.normals.rows() != 0) appendRow(out, cloud.normals, i, true);
    if (cloud.colors.rows() == 0) continue;
    // Blue first, opaque: what PCL keeps in the bits of a float.
    for (int c = 2; c >= 0; --c) out += static_cast<char>(cloud.colors(i, c));
    out += '\xff';
  }
  return out;
}

std::string toPly(const PointCloud& cloud) {
  const bool floats = fitFloats(cloud.points);
  const auto properties = [](const std::string& type, std::initializer_list<const char*> names) {
    std::string lines;
    for (const char* const name : names) lines += "\nproperty " + type + ' ' + name;
    return lines;
  };
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  appendNumber(out, cloud.points.rows());
  out += perColumn(cloud,
                   properties(floats ? "float" : "double", {"x", "y", "z"}),
                   properties("float", {"nx", "ny", "nz"}),
                   properties("uchar", {"red", "green", "blue"}));
  out += "\nend_header\n";
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    appendRow(out, cloud.points, i, floats);
    if (cloud.normals.rows() != 0) appendRow(out, cloud.normals, i, true);
    if (cloud.colors.rows() != 0) appendRow(out, cloud.colors, i);
  }
  return out;
}

std::string toXyz(const PointCloud& cloud) {
  std::string out;
  if (cloud.normals.rows() != 0 || cloud.colors.rows() != 0)
    out = "#" + perColumn(cloud, " x y z", " nx ny nz", " r g b") + "\n";
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    appendNumbers(out, ' ', cloud.points(i, 0), cloud.points(i, 1), cloud.points(i, 2));
    if (cloud.normals.rows() != 0) {
      out += ' ';
      appendNumbers(out, ' ', cloud.normals(i, 0), cloud.normals(i, 1), cloud.normals(i, 2));
    }
    if (cloud.colors.rows() != 0) {
      out += ' ';
      appendNumbers(
          out, ' ', int{cloud.colors(i, 0)}, int{cloud.colors(i, 1)}, int{cloud.colors(i, 2)});
    }
    out += '\n';
  }
  return out;
}

void checkParts(const PointCloud& cloud) {
  const auto fits = [&](Eigen::Index rows) { return rows == 0 || rows == cloud.points.rows(); };
  require(cloud.points.rows() > 0, "a cloud without points");
  require(fits(cloud.normals.rows()), "a normal for some points only");
  require(fits(cloud.colors.rows()), "a color for some points only");
  require(cloud.width >= 0 && (cloud.width == 0 || cloud.points.rows() % cloud.width == 0),
          "the points do not fill a grid " + std::to_string(cloud.width) + " wide");
}

std::string encode(const std::filesystem::path& path, const PointCloud& cloud) {
  const std::string ending = lowercase(path.extension().string());
  if (ending == ".pcd") return toPcd(cloud);
  if (ending == ".ply") return toPly(cloud);
  if (ending == ".xyz") return toXyz(cloud);
  throw std::invalid_argument(onOneLine(path.string()) +
                              ": a point cloud is written to .pcd, .ply or .xyz");
}

}  // namespace

void writePointCloud(const std::filesystem::path& path, const PointCloud& cloud) {
  checkParts(cloud);
  writeFile(path, encode(path, cloud));
}

}  // namespace posture
