// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/shape_io.h>

#include "readers.h"
#include "text.h"
#include "text_reader.h"
#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <utility>

namespace posture {
namespace {

bool isPcd(const Input& input) {
  return input.bytes().substr(textBegin(input.bytes()), 6) == "# .PCD" ||
         lowercase(input.path().extension().string()) == ".pcd";
}

bool hasTableEnding(const Input& input) {
  constexpr std::string_view ENDINGS[] = {
      ".xyz", ".txt", ".csv", ".asc", ".pts", ".xyzn", ".xyzrgb"};
  const std::string ending = lowercase(input.path().extension().string());
  return std::find(std::begin(ENDINGS), std::end(ENDINGS), ending) != std::end(ENDINGS);
}

/// What was not seen becomes NaN, a normal that is unknown zero.
void settle(PointCloud& cloud, const Input& input) {
  bool any_seen = false;
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    if (cloud.points.row(i).allFinite())
      any_seen = true;
    else
      cloud.points.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  if (!any_seen)
    input.fail("none of its " + std::to_string(cloud.points.rows()) +
               " points has finite coordinates");
  for (Eigen::Index i = 0; i < cloud.normals.rows(); ++i)
    if (!cloud.normals.row(i).allFinite()) cloud.normals.row(i).setZero();
  if (cloud.normals.isZero(0)) cloud.normals.resize(0, 3);
}

Shape toShape(MeshFile&& file) {
  Shape shape;
  shape.cloud.points = std::move(file.mesh.vertices);
  shape.cloud.normals = std::move(file.normals);
  shape.cloud.colors = std::move(file.colors);
  shape.faces = std::move(file.mesh.faces);
  return shape;
}

Shape readAnyShape(const Input& input) {
  Shape shape;
  if (isPcd(input)) {
    shape.cloud = readPcd(input);
  } else if (hasTableEnding(input) && signatureOf(input) == MeshFormat::UNKNOWN) {
    shape.cloud = readTable(input);
  } else {
    const MeshFormat format = meshFormatOf(input);
    if (format == MeshFormat::UNKNOWN)
      input.fail(
          "unknown format (PLY, OBJ, OFF, STL, legacy VTK, PCD, XYZ, TXT, CSV, ASC and PTS "
          "can be read)");
    shape = toShape(readMeshAs(format, input, Unseen::KEPT_IN_CLOUDS));
  }
  if (shape.faces.rows() == 0) settle(shape.cloud, input);
  return shape;
}

}  // namespace

Shape readShape(const std::filesystem::path& path) {
  const Input input(path);
  try {
    return readAnyShape(input);
  } catch (const std::bad_alloc&) {
    input.fail("too large for this machine's memory");
  }
}

}  // namespace posture
