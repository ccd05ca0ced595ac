// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cloud_message.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <stdexcept>
#include <support/files.h>

namespace posture::app {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointCloud2ConstIterator;
using sensor_msgs::PointField;
using test::inputErrorOf;

constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

PointField field(const std::string& name, std::uint32_t offset, std::uint8_t datatype) {
  PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = datatype;
  field.count = 1;
  return field;
}

template <class Number>
void put(PointCloud2& message, std::size_t at, Number number, bool swapped) {
  std::array<std::uint8_t, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), &number, sizeof number);
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  std::copy(bytes.begin(), bytes.end(), message.data.begin() + static_cast<std::ptrdiff_t>(at));
}

/// 2 x 3 points as a driver may send them: y before x, x double, a ring number and a label between,
/// rows padded. Point i is (i, 10 i, 100 i), or was not seen for i = 4.
PointCloud2 oddMessage(bool swapped) {
  PointCloud2 message;
  message.height = 2;
  message.width = 3;
  message.point_step = 24;
  message.row_step = 3 * 24 + 5;
  message.is_bigendian = swapped;  // these tests run on little-endian machines
  message.fields = {field("ring", 0, PointField::UINT16),
                    field("y", 4, PointField::FLOAT32),
                    field("x", 8, PointField::FLOAT64),
                    field("z", 16, PointField::FLOAT32),
                    field("label", 20, PointField::INT32)};
  message.data.resize(2 * message.row_step, 0xab);
  for (int i = 0; i < 6; ++i) {
    const std::size_t at = i / 3 * message.row_step + i % 3 * message.point_step;
    put(message, at, static_cast<std::uint16_t>(7 * i), swapped);
    put(message, at + 4, static_cast<float>(i == 4 ? NONE : 10 * i), swapped);
    put(message, at + 8, static_cast<double>(i), swapped);
    put(message, at + 16, static_cast<float>(100 * i), swapped);
    put(message, at + 20, -i, swapped);
  }
  return message;
}

class OddMessage : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(ByteOrders, OddMessage, testing::Values(false, true));

TEST_P(OddMessage, isReadAsAGrid) {
  const PointCloud cloud = cloudOf(oddMessage(GetParam()));
  EXPECT_EQ(cloud.width, 3);
  EXPECT_EQ(cloud.normals.rows(), 0);
  ASSERT_EQ(cloud.points.rows(), 6);
  for (int i : {0, 1, 2, 3, 5})
    EXPECT_EQ(cloud.points.row(i), Eigen::RowVector3d(i, 10 * i, 100 * i));
  EXPECT_TRUE(std::isnan(cloud.points(4, 1)));
}

TEST_P(OddMessage, keepsAllButThePointsWhenTheyMove) {
  const PointCloud2 message = oddMessage(GetParam());
  const Points places = cloudOf(message).points.array() + 0.5;
  const PointCloud2 there = moved(message, places, {});
  EXPECT_EQ(there.row_step, message.row_step);
  EXPECT_EQ(there.is_bigendian, message.is_bigendian);
  EXPECT_FALSE(there.is_dense);
  const Points read = cloudOf(there).points;
  EXPECT_EQ(read.topRows(4), places.topRows(4));
  EXPECT_TRUE(std::isnan(read(4, 1)));
  // What is in no coordinate is the same, padding included.
  PointCloud2 back = moved(there, cloudOf(message).points, {});
  EXPECT_EQ(back.data, message.data);
}

TEST_P(OddMessage, takesFurtherFields) {
  PointCloud2 message = oddMessage(GetParam());
  appendField(message, "one", std::vector<float>{0, 1.5, 2.5, 3.5, 4.5, 5.5});
  appendField(message, "two", std::vector<std::int32_t>{0, -1, -2, -3, -4, -5});
  EXPECT_EQ(message.point_step, 32U);
  EXPECT_EQ(message.row_step, 96U);
  EXPECT_EQ(message.fields.size(), 7U);
  EXPECT_EQ(cloudOf(message).points.topRows(4), cloudOf(oddMessage(GetParam())).points.topRows(4));
  if (GetParam()) return;  // the iterators of sensor_msgs do not swap
  PointCloud2ConstIterator<float> one(message, "one");
  PointCloud2ConstIterator<std::int32_t> two(message, "two"), label(message, "label");
  for (int i = 0; i < 6; ++i, ++one, ++two, ++label) {
    EXPECT_EQ(*one, i == 0 ? 0 : static_cast<float>(i + 0.5));
    EXPECT_EQ(*two, -i);
    EXPECT_EQ(*label, -i);
  }
}

PointCloud smallCloud() {
  PointCloud cloud;
  cloud.points.resize(4, 3);
  cloud.points << 1, 2, 3, 4, 5, 6, NONE, NONE, NONE, 7, 8, 9;
  cloud.normals.resize(4, 3);
  cloud.normals << 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0;
  cloud.colors.resize(4, 3);
  cloud.colors << 1, 2, 3, 250, 251, 252, 0, 0, 0, 9, 8, 7;
  return cloud;
}

TEST(MessageOf, isWhatViewersRead) {
  std_msgs::Header header;
  header.frame_id = "stage";
  const PointCloud cloud = smallCloud();
  const PointCloud2 message = messageOf(cloud, header);
  EXPECT_EQ(message.header.frame_id, "stage");
  EXPECT_EQ(message.height, 1U);
  EXPECT_EQ(message.width, 4U);
  EXPECT_FALSE(message.is_dense);
  PointCloud2ConstIterator<float> x(message, "x"), normal(message, "normal_x");
  PointCloud2ConstIterator<std::uint8_t> red(message, "r"), blue(message, "b");
  for (int i = 0; i < 4; ++i, ++x, ++normal, ++red, ++blue) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(x[k] == cloud.points(i, k) || i == 2);
      EXPECT_EQ(normal[k], cloud.normals(i, k));
    }
    EXPECT_EQ(*red, cloud.colors(i, 0));
    EXPECT_EQ(*blue, cloud.colors(i, 2));
  }
}

TEST(MessageOf, gridsStayGrids) {
  PointCloud cloud = smallCloud();
  cloud.width = 2;
  const PointCloud2 message = messageOf(cloud, {});
  EXPECT_EQ(message.width, 2U);
  EXPECT_EQ(message.height, 2U);
  EXPECT_EQ(cloudOf(message).width, 2);
}

TEST(MessageOf, comesBack) {
  const PointCloud cloud = smallCloud(), back = cloudOf(messageOf(cloud, {}));
  EXPECT_EQ(back.points.bottomRows(1), cloud.points.bottomRows(1));
  EXPECT_EQ(back.normals, cloud.normals);
  EXPECT_EQ(back.width, 0);
}

TEST(Moved, takesNormalsAlong) {
  const PointCloud cloud = smallCloud();
  const PointCloud there =
      cloudOf(moved(messageOf(cloud, {}), Points::Zero(4, 3), 2 * cloud.normals));
  EXPECT_EQ(there.normals, 2 * cloud.normals);
  EXPECT_TRUE(there.points.isZero());
  EXPECT_THROW(moved(messageOf(cloud, {}), Points::Zero(3, 3), cloud.normals),
               std::invalid_argument);
}

TEST(CloudOf, damagedMessagesAreRefused) {
  const auto reason = [](auto damage) {
    PointCloud2 message = oddMessage(false);
    damage(message);
    return inputErrorOf([&] { cloudOf(message); });
  };
  using testing::HasSubstr;
  EXPECT_EQ(inputErrorOf([] { cloudOf({}); }), "has no points");
  EXPECT_THAT(reason([](PointCloud2& m) {
                m.data.pop_back();
                m.data.resize(m.data.size() - 5);
              }),
              HasSubstr("fewer data"));
  EXPECT_THAT(reason([](PointCloud2& m) { m.height = 1U << 31; }), HasSubstr("too many"));
  EXPECT_THAT(reason([](PointCloud2& m) { m.height = 1U << 20; }), HasSubstr("fewer data"));
  EXPECT_THAT(reason([](PointCloud2& m) { m.row_step = 8; }), HasSubstr("fewer data"));
  EXPECT_THAT(reason([](PointCloud2& m) { m.fields[1].name = "u"; }), HasSubstr("x, y and z"));
  EXPECT_THAT(reason([](PointCloud2& m) { m.fields[2].offset = 17; }), HasSubstr("beyond the end"));
  EXPECT_THAT(reason([](PointCloud2& m) { m.fields[3].offset = 0xffffffff; }),
              HasSubstr("beyond the end"));
  EXPECT_THAT(reason([](PointCloud2& m) { m.fields[3].datatype = PointField::INT16; }),
              HasSubstr("FLOAT"));
  EXPECT_EQ(reason([](PointCloud2& m) { m.data.resize(m.data.size() - 5); }), "")
      << "the last row needs no padding";
}

}  // namespace
}  // namespace posture::app
