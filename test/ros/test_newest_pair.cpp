// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/make_shared.hpp>
#include <gtest/gtest.h>

#include "newest_pair.h"
#include <future>

namespace posture::app {
namespace {

Side side(int stamp) {
  auto message = boost::make_shared<sensor_msgs::PointCloud2>();
  message->header.seq = static_cast<std::uint32_t>(stamp);
  return {message, nullptr};
}

/// Stamps of the pair that is due; there must be one.
std::pair<int, int> taken(NewestPair& pairs) {
  const std::optional<Pair> pair = pairs.take();
  return {pair->source.message->header.seq, pair->target.message->header.seq};
}

using Stamps = std::pair<int, int>;

TEST(NewestPair, waitsForBothSides) {
  NewestPair pairs;
  EXPECT_FALSE(pairs.again());
  pairs.setSource(side(1));
  EXPECT_FALSE(pairs.again());
  auto pair = std::async(std::launch::async, [&] { return taken(pairs); });
  EXPECT_EQ(pair.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  pairs.setTarget(side(2));
  EXPECT_EQ(pair.get(), Stamps(1, 2));
}

TEST(NewestPair, newerOnesTakeThePlaceOfThoseThatWait) {
  NewestPair pairs;
  for (int i = 0; i < 3; ++i) pairs.setSource(side(i));
  for (int i = 0; i < 5; ++i) pairs.setTarget(side(i));
  EXPECT_EQ(taken(pairs), Stamps(2, 4));
  pairs.close();
  EXPECT_FALSE(pairs.take()) << "a pair was handed out twice";
}

TEST(NewestPair, oneSideStaysUntilItsNextComes) {
  NewestPair pairs;
  pairs.setTarget(side(100));
  for (int i = 0; i < 3; ++i) {
    pairs.setSource(side(i));
    EXPECT_EQ(taken(pairs), Stamps(i, 100));
    EXPECT_FALSE(pairs.outdated());
  }
  pairs.setTarget(side(101));
  EXPECT_EQ(taken(pairs), Stamps(2, 101));
}

TEST(NewestPair, halfAPairIsOutdatedByItsOtherHalf) {
  NewestPair pairs;
  pairs.setSource(side(1));
  pairs.setTarget(side(1));
  taken(pairs);
  pairs.setSource(side(2));
  EXPECT_FALSE(pairs.outdated()) << "the pair that is taken was whole";
  EXPECT_EQ(taken(pairs), Stamps(2, 1));
  pairs.setSource(side(3));
  EXPECT_FALSE(pairs.outdated()) << "a stream of sources would never be registered";
  pairs.setTarget(side(3));
  EXPECT_TRUE(pairs.outdated());
  EXPECT_EQ(taken(pairs), Stamps(3, 3));
  EXPECT_FALSE(pairs.outdated());
}

TEST(NewestPair, twoStreamsDoNotOutdateEachOtherForEver) {
  NewestPair pairs;
  pairs.setSource(side(0));
  pairs.setTarget(side(0));
  taken(pairs);
  // One after the other, each while the pair with the other is registered.
  pairs.setSource(side(1));
  EXPECT_EQ(taken(pairs), Stamps(1, 0));
  pairs.setTarget(side(1));
  EXPECT_TRUE(pairs.outdated());
  EXPECT_EQ(taken(pairs), Stamps(1, 1)) << "the halves that belong together";
  pairs.setSource(side(2));
  EXPECT_FALSE(pairs.outdated()) << "both sides were new to what is registered";
  pairs.setTarget(side(2));
  EXPECT_FALSE(pairs.outdated());
  EXPECT_EQ(taken(pairs), Stamps(2, 2));
  // The other way around.
  pairs.setTarget(side(3));
  EXPECT_EQ(taken(pairs), Stamps(2, 3));
  pairs.setSource(side(3));
  EXPECT_TRUE(pairs.outdated());
  EXPECT_EQ(taken(pairs), Stamps(3, 3));
  pairs.setTarget(side(4));
  EXPECT_FALSE(pairs.outdated());
  // What was new to a pair that was registered whole is not new to the next.
  EXPECT_EQ(taken(pairs), Stamps(3, 4));
  pairs.setSource(side(4));
  EXPECT_TRUE(pairs.outdated());
}

TEST(NewestPair, againIsOnce) {
  NewestPair pairs;
  pairs.setSource(side(1));
  pairs.setTarget(side(2));
  taken(pairs);
  EXPECT_TRUE(pairs.again());
  EXPECT_TRUE(pairs.again());
  EXPECT_EQ(taken(pairs), Stamps(1, 2));
  pairs.setTarget(side(3));
  EXPECT_FALSE(pairs.outdated()) << "both sides were asked for as they are";
  EXPECT_EQ(taken(pairs), Stamps(1, 3));
  pairs.close();
  EXPECT_FALSE(pairs.take());
}

TEST(NewestPair, closeEndsTheWaiting) {
  NewestPair pairs;
  auto pair = std::async(std::launch::async, [&] { return pairs.take().has_value(); });
  pairs.close();
  EXPECT_FALSE(pair.get());
  EXPECT_TRUE(pairs.closed());
}

}  // namespace
}  // namespace posture::app
