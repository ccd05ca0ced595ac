// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/registration/single_precision.h>

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace posture {
namespace {

bool isDouble(const pcl::PCLPointField& field) {
  return field.datatype == pcl::PCLPointField::FLOAT64;
}

/// A count of 0 stands for one number.
std::size_t countOf(const pcl::PCLPointField& field) {
  return std::max<std::size_t>(1, field.count);
}

void narrow(const std::uint8_t* from, std::size_t count, std::uint8_t* to) {
  for (std::size_t i = 0; i < count; ++i) {
    double wide;
    std::memcpy(&wide, from + i * sizeof wide, sizeof wide);
    const auto single = static_cast<float>(wide);
    std::memcpy(to + i * sizeof single, &single, sizeof single);
  }
}

/// Whether every point and field is within the data.
bool isWhole(const pcl::PCLPointCloud2& cloud) {
  const auto fits = [&](const pcl::PCLPointField& field) {
    return std::size_t{field.offset} + countOf(field) * sizeof(double) <= cloud.point_step ||
           !isDouble(field);
  };
  return std::all_of(cloud.fields.begin(), cloud.fields.end(), fits) &&
         cloud.row_step >= std::size_t{cloud.width} * cloud.point_step &&
         cloud.data.size() >= std::size_t{cloud.height} * cloud.row_step;
}

}  // namespace

pcl::PCLPointCloud2 inSinglePrecision(const pcl::PCLPointCloud2& cloud) {
  pcl::PCLPointCloud2 single = cloud;
  if (std::none_of(cloud.fields.begin(), cloud.fields.end(), isDouble) || !isWhole(cloud))
    return single;
  // Where it was, in half the room: all else keeps its place.
  for (pcl::PCLPointField& field : single.fields) {
    if (!isDouble(field)) continue;
    for (std::size_t row = 0; row < cloud.height; ++row)
      for (std::size_t column = 0; column < cloud.width; ++column) {
        const std::size_t at = row * cloud.row_step + column * cloud.point_step + field.offset;
        narrow(&cloud.data[at], countOf(field), &single.data[at]);
      }
    field.datatype = pcl::PCLPointField::FLOAT32;
  }
  return single;
}

}  // namespace posture
