// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "byte_order.h"
#include "color_byte.h"
#include "pcd_header.h"
#include "readers.h"
#include "text.h"
#include "text_reader.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <lzf.h>
#include <string>
#include <vector>

namespace posture {
namespace {

using Places = std::array<int, 3>;

bool complete(const Places& places) {
  return std::all_of(places.begin(), places.end(), [](int place) { return place >= 0; });
}

/// Which fields hold what; -1: none.
struct PcdLayout {
  explicit PcdLayout(const PcdHeader& header)
      : position{header.find({"x"}), header.find({"y"}), header.find({"z"})},
        normal{header.find({"normal_x", "nx"}),
               header.find({"normal_y", "ny"}),
               header.find({"normal_z", "nz"})},
        color{header.find({"r", "red"}), header.find({"g", "green"}), header.find({"b", "blue"})},
        packed_color(header.find({"rgb", "rgba"})) {
    if (packed_color >= 0 &&
        sizeOf(header.fields[static_cast<std::size_t>(packed_color)].type) != 4)
      packed_color = -1;
  }

  bool hasColors() const { return packed_color >= 0 || complete(color); }
  bool uses(int place) const {
    const auto in = [place](const Places& places) {
      return std::find(places.begin(), places.end(), place) != places.end();
    };
    return place == packed_color || in(position) || in(normal) || in(color);
  }

  Places position, normal, color;
  int packed_color;
};

/// The points, filled from one number a field.
class PcdCloud {
 public:
  PcdCloud(const PcdHeader& header, const PcdLayout& layout) : layout_(layout) {
    const auto points = static_cast<Eigen::Index>(header.points);
    cloud_.points.resize(points, 3);
    cloud_.normals.resize(complete(layout.normal) ? points : 0, 3);
    cloud_.colors.resize(layout.hasColors() ? points : 0, 3);
    const bool is_grid = header.height > 1 && header.width > 1;
    if (is_grid) cloud_.width = static_cast<int>(header.width);
    if (is_grid || !header.viewpoint.isZero(0)) cloud_.sensor = header.viewpoint;
  }

  void set(Eigen::Index row, const std::vector<double>& values) {
    const auto at = [&](int place) { return values[static_cast<std::size_t>(place)]; };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto column = static_cast<Eigen::Index>(axis);
      cloud_.points(row, column) = at(layout_.position[axis]);
      if (cloud_.normals.rows() != 0) cloud_.normals(row, column) = at(layout_.normal[axis]);
      if (cloud_.colors.rows() == 0) continue;
      if (layout_.packed_color >= 0)
        cloud_.colors(row, column) = static_cast<std::uint8_t>(
            static_cast<std::uint32_t>(at(layout_.packed_color)) >> (16 - 8 * axis) & 0xff);
      else
        cloud_.colors(row, column) = colorByte(at(layout_.color[axis]));
    }
  }

  PointCloud take() { return std::move(cloud_); }

 private:
  const PcdLayout& layout_;
  PointCloud cloud_;
};

/// 0xAARRGGBB, which PCL also keeps in the bits of a float.
double packedColor(double value, Scalar type) {
  if (type == Scalar::FLOAT) {
    const auto narrow = static_cast<float>(value);
    std::uint32_t bits;
    std::memcpy(&bits, &narrow, sizeof bits);
    return bits;
  }
  if (!(std::abs(value) < 0x1p33)) return 0;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
}

PointCloud readAscii(const Input& input, const PcdHeader& header, const PcdLayout& layout) {
  PcdCloud cloud(header, layout);
  TextReader text(input, header.size, '#');
  std::vector<double> values(header.fields.size());
  for (std::size_t point = 0; point < header.points; ++point) {
    std::string_view word = text.word();
    if (word.empty())
      text.fail("truncated: " + std::to_string(point) + " of " + std::to_string(header.points) +
                " points");
    for (std::size_t f = 0; f < values.size(); ++f) {
      const PcdField& field = header.fields[f];
      for (std::size_t i = 0; i < field.count; ++i, word = text.wordOnLine()) {
        if (word.empty()) text.fail("a point with too few numbers (truncated?)");
        if (i != 0 || !layout.uses(static_cast<int>(f))) continue;
        values[f] = text.number(word, field.name.c_str());
        if (static_cast<int>(f) == layout.packed_color)
          values[f] = packedColor(values[f], field.type);
      }
    }
    if (!word.empty()) text.fail("a point with too many numbers");
    cloud.set(static_cast<Eigen::Index>(point), values);
  }
  if (!text.atEnd())
    text.fail("more than the " + std::to_string(header.points) + " points of its header");
  return cloud.take();
}

/// Where the first number of each field stands, and how far apart those of two points are.
struct BinaryPlaces {
  std::vector<std::size_t> first, step;
};

/// Point after point, or (compressed) field after field.
BinaryPlaces placesOf(const PcdHeader& header) {
  BinaryPlaces places;
  const bool by_field = header.encoding == PcdEncoding::COMPRESSED;
  const std::size_t record = header.record();
  std::size_t offset = 0;
  for (const PcdField& field : header.fields) {
    places.first.push_back(offset);
    places.step.push_back(by_field ? field.bytes() : record);
    offset += by_field ? field.bytes() * header.points : field.bytes();
  }
  return places;
}

PointCloud readBinary(std::string_view bytes, const PcdHeader& header, const PcdLayout& layout) {
  PcdCloud cloud(header, layout);
  const BinaryPlaces places = placesOf(header);
  std::vector<double> values(header.fields.size());
  for (std::size_t point = 0; point < header.points; ++point) {
    for (std::size_t f = 0; f < values.size(); ++f) {
      const int place = static_cast<int>(f);
      if (!layout.uses(place)) continue;
      // Not by way of a float, which need not keep the bits of a NaN.
      const Scalar type = place == layout.packed_color ? Scalar::UINT32 : header.fields[f].type;
      values[f] =
          loadScalar(bytes, places.first[f] + point * places.step[f], type, ByteOrder::LITTLE);
    }
    cloud.set(static_cast<Eigen::Index>(point), values);
  }
  return cloud.take();
}

/// What is shorter than a point is let pass.
void checkRest(const Input& input, const PcdHeader& header, std::string_view rest) {
  if (rest.size() >= header.record() && !isPadding(rest))
    input.fail("more than the " + std::to_string(header.points) +
               " points of its header: " + std::to_string(rest.size()) + " bytes behind them");
}

/// Two lengths, then as many bytes compressed.
std::string decompress(const Input& input, const PcdHeader& header) {
  const std::string_view bytes = input.bytes().substr(header.size);
  if (bytes.size() < 8) input.fail("truncated: the sizes of the compressed points are missing");
  const std::size_t packed = loadNumber<std::uint32_t>(bytes, 0, ByteOrder::LITTLE);
  const std::size_t full = loadNumber<std::uint32_t>(bytes, 4, ByteOrder::LITTLE);
  if (packed > bytes.size() - 8)
    input.fail("truncated: " + std::to_string(bytes.size() - 8) + " of " + std::to_string(packed) +
               " compressed bytes");
  const std::size_t record = header.record();
  if (full % record != 0 || full / record != header.points)
    input.fail("its " + std::to_string(header.points) + " points of " + std::to_string(record) +
               " bytes are not the " + std::to_string(full) + " bytes that were compressed");
  // Three bytes of LZF stand for 264 at most.
  constexpr std::size_t MOST_PER_BYTE = 264 / 3;
  std::string points(full / MOST_PER_BYTE > packed ? 0 : full, '\0');
  if (points.empty() || lzf_decompress(bytes.data() + 8,
                                       static_cast<unsigned>(packed),
                                       points.data(),
                                       static_cast<unsigned>(full)) != full)
    input.fail("the compressed points are damaged");
  checkRest(input, header, bytes.substr(8 + packed));
  return points;
}

}  // namespace

PointCloud readPcd(const Input& input) {
  const PcdHeader header = readPcdHeader(input);
  const PcdLayout layout(header);
  if (!complete(layout.position)) input.fail("its points have no x, y and z");
  if (header.encoding == PcdEncoding::ASCII) return readAscii(input, header, layout);
  if (header.encoding == PcdEncoding::COMPRESSED)
    return readBinary(decompress(input, header), header, layout);
  const std::string_view bytes = input.bytes().substr(header.size);
  checkRest(input, header, bytes.substr(header.points * header.record()));
  return readBinary(bytes, header, layout);
}

}  // namespace posture
