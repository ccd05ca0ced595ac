// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_message.h"

#include <posture/core/error.h>

#include <boost/predef/other/endian.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>

namespace posture::app {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;
using Bytes = std::array<std::uint8_t, 8>;
using Triple = std::array<PointField, 3>;

constexpr bool BIG_ENDIAN_MACHINE = BOOST_ENDIAN_BIG_BYTE != 0;

bool isReal(const PointField& field) {
  return field.datatype == PointField::FLOAT32 || field.datatype == PointField::FLOAT64;
}

/// \param field  a real number.
std::size_t sizeOf(const PointField& field) {
  return field.datatype == PointField::FLOAT64 ? sizeof(double) : sizeof(float);
}

/// The bytes of a number in the order of this machine.
Bytes ordered(const std::uint8_t* bytes, std::size_t size, bool big_endian) {
  Bytes result{};
  std::copy_n(bytes, size, result.begin());
  if (big_endian != BIG_ENDIAN_MACHINE)
    std::reverse(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(size));
  return result;
}

template <class Number>
double as(const Bytes& bytes) {
  Number number;
  std::memcpy(&number, bytes.data(), sizeof(Number));
  return static_cast<double>(number);
}

template <class Number>
Bytes from(double value) {
  const auto number = static_cast<Number>(value);
  Bytes bytes{};
  std::memcpy(bytes.data(), &number, sizeof(Number));
  return bytes;
}

double numberIn(const PointField& field, const std::uint8_t* point, bool big_endian) {
  const Bytes bytes = ordered(point + field.offset, sizeOf(field), big_endian);
  return field.datatype == PointField::FLOAT64 ? as<double>(bytes) : as<float>(bytes);
}

void put(double value, const PointField& field, std::uint8_t* point, bool big_endian) {
  const Bytes bytes =
      field.datatype == PointField::FLOAT64 ? from<double>(value) : from<float>(value);
  const std::size_t size = sizeOf(field);
  std::copy_n(ordered(bytes.data(), size, big_endian).begin(), size, point + field.offset);
}

std::optional<PointField> findField(const PointCloud2& message, const std::string& name) {
  for (const PointField& field : message.fields)
    if (field.name == name) return field;
  return std::nullopt;
}

/// Three coordinates; none where one is missing.
std::optional<Triple> findTriple(const PointCloud2& message,
                                 const std::array<std::string, 3>& names) {
  Triple triple;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<PointField> field = findField(message, names[k]);
    if (!field) return std::nullopt;
    if (!isReal(*field))
      throw InputError("has a field \"" + field->name + "\" that is neither FLOAT32 nor FLOAT64");
    if (field->offset + sizeOf(*field) > message.point_step)
      throw InputError("has a field \"" + field->name + "\" beyond the end of a point");
    triple[k] = *field;
  }
  return triple;
}

std::optional<Triple> positionsOf(const PointCloud2& message) {
  return findTriple(message, {"x", "y", "z"});
}

std::optional<Triple> normalsOf(const PointCloud2& message) {
  return findTriple(message, {"normal_x", "normal_y", "normal_z"});
}

std::size_t countOf(const PointCloud2& message) {
  return std::size_t{message.height} * message.width;
}

/// Where point i begins in the data.
std::size_t placeOf(const PointCloud2& message, std::size_t i) {
  return i / message.width * message.row_step + i % message.width * message.point_step;
}

void checkLayout(const PointCloud2& message) {
  const std::size_t count = countOf(message);
  if (count == 0) throw InputError("has no points");
  if (count > std::numeric_limits<int>::max()) throw InputError("has too many points");
  if (std::size_t{message.row_step} < std::size_t{message.width} * message.point_step ||
      message.data.size() < placeOf(message, count - 1) + message.point_step)
    throw InputError("has fewer data than its height, width and steps say");
}

Points read(const PointCloud2& message, const Triple& fields) {
  const std::size_t count = countOf(message);
  Points rows(count, 3);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      rows(i, k) =
          numberIn(fields[k], message.data.data() + placeOf(message, i), message.is_bigendian != 0);
  return rows;
}

void write(const Points& rows, const Triple& fields, PointCloud2& message) {
  require(rows.rows() == static_cast<Eigen::Index>(countOf(message)),
          "not as many rows as the message has points");
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      put(rows(i, k), fields[k], message.data.data() + placeOf(message, i), message.is_bigendian);
}

/// Adds room for four more bytes to every point; rows then have no padding.
PointField addRoom(PointCloud2& message, const std::string& name, std::uint8_t datatype) {
  PointField field;
  field.name = name;
  field.datatype = datatype;
  field.count = 1;
  field.offset = message.point_step;
  const std::uint32_t step = message.point_step + 4;
  std::vector<std::uint8_t> data(countOf(message) * step);
  for (std::size_t i = 0; i < countOf(message); ++i)
    std::copy_n(message.data.data() + placeOf(message, i), message.point_step, &data[i * step]);
  message.data = std::move(data);
  message.point_step = step;
  message.row_step = message.width * message.point_step;
  message.fields.push_back(field);
  return field;
}

template <class Number>
void append(PointCloud2& message,
            const std::string& name,
            std::uint8_t datatype,
            const std::vector<Number>& values) {
  static_assert(sizeof(Number) == 4);
  require(values.size() == countOf(message), "not as many values as the message has points");
  const PointField field = addRoom(message, name, datatype);
  for (std::size_t i = 0; i < values.size(); ++i) {
    Bytes bytes{};
    std::memcpy(bytes.data(), &values[i], sizeof(Number));
    std::copy_n(ordered(bytes.data(), sizeof(Number), message.is_bigendian != 0).begin(),
                sizeof(Number),
                message.data.begin() + placeOf(message, i) + field.offset);
  }
}

/// As PCL and the viewers have it: 0x00RRGGBB in the bits of a float.
std::vector<float> packed(const Colors& colors) {
  std::vector<float> values(static_cast<std::size_t>(colors.rows()));
  for (Eigen::Index i = 0; i < colors.rows(); ++i) {
    const std::uint32_t bits =
        std::uint32_t{colors(i, 0)} << 16 | std::uint32_t{colors(i, 1)} << 8 | colors(i, 2);
    std::memcpy(&values[static_cast<std::size_t>(i)], &bits, sizeof bits);
  }
  return values;
}

std::vector<float> column(const Points& rows, int k) {
  const Eigen::VectorXf values = rows.col(k).cast<float>();
  return {values.data(), values.data() + values.size()};
}

}  // namespace

PointCloud cloudOf(const PointCloud2& message) {
  checkLayout(message);
  const std::optional<Triple> positions = positionsOf(message);
  if (!positions) throw InputError("has no fields x, y and z");
  PointCloud cloud;
  cloud.points = read(message, *positions);
  if (const std::optional<Triple> normals = normalsOf(message))
    cloud.normals = read(message, *normals);
  if (message.height > 1 && message.width > 1) cloud.width = static_cast<int>(message.width);
  return cloud;
}

PointCloud2 messageOf(const PointCloud& cloud, const std_msgs::Header& header) {
  PointCloud2 message;
  message.header = header;
  const auto count = static_cast<std::uint32_t>(cloud.points.rows());
  message.width = cloud.width > 0 ? static_cast<std::uint32_t>(cloud.width) : count;
  message.height = message.width > 0 ? count / message.width : 1;
  message.is_bigendian = BIG_ENDIAN_MACHINE;
  message.is_dense = cloud.points.allFinite();
  const char* const names[] = {"x", "y", "z", "normal_x", "normal_y", "normal_z"};
  for (int k = 0; k < 3; ++k) appendField(message, names[k], column(cloud.points, k));
  if (cloud.normals.rows() > 0)
    for (int k = 0; k < 3; ++k) appendField(message, names[3 + k], column(cloud.normals, k));
  if (cloud.colors.rows() > 0) appendField(message, "rgb", packed(cloud.colors));
  return message;
}

PointCloud2 moved(PointCloud2 message, const Points& points, const Points& normals) {
  const std::optional<Triple> position_fields = positionsOf(message);
  require(position_fields.has_value(), "a message without positions");
  write(points, *position_fields, message);
  if (const std::optional<Triple> normal_fields = normalsOf(message))
    write(normals, *normal_fields, message);
  message.is_dense = points.allFinite();
  return message;
}

void appendField(PointCloud2& message, const std::string& name, const std::vector<float>& values) {
  append(message, name, PointField::FLOAT32, values);
}

void appendField(PointCloud2& message,
                 const std::string& name,
                 const std::vector<std::int32_t>& values) {
  append(message, name, PointField::INT32, values);
}

}  // namespace posture::app
