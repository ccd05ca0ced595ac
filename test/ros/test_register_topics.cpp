// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>
#include <posture/io/shape_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../apps/program.h"
#include "cloud_message.h"
#include "node_outputs.h"
#include <array>
#include <csignal>
#include <limits>
#include <map>
#include <ros/callback_queue.h>
#include <std_srvs/Trigger.h>

// The node runs beside this program, see register_topics.test. The tests go on from each other.
namespace posture::test {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using sensor_msgs::PointCloud2;
using visualization_msgs::Marker;

const std::string BODY = DATA_DIR "/human/human-pose";

constexpr int UNSEEN = 25;  // points without coordinates behind those of the body

/// The vertices of a bundled body, points that were not seen behind them, and a field of its own.
PointCloud2 cloudMessage(int pose, const std::string& frame, double stamp) {
  const Points all = readShape(BODY + std::to_string(pose) + ".ply").cloud.points;
  PointCloud cloud;
  cloud.points = Points::Constant(all.rows() + UNSEEN, 3, std::numeric_limits<double>::quiet_NaN());
  std::vector<std::int32_t> number;
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    if (i < all.rows()) cloud.points.row(i) = all.row(i);
    number.push_back(static_cast<std::int32_t>(1000 + i));
  }
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = ros::Time(stamp);
  PointCloud2 message = app::messageOf(cloud, header);
  app::appendField(message, "number", number);
  return message;
}

/// Publishers that keep what they said for those who come later, and all that the node says.
struct Topics {
  Topics()
      : source(outputs.node.advertise<PointCloud2>("/posture/source", 1, true)),
        target(outputs.node.advertise<PointCloud2>("/posture/target", 1, true)) {}

  DiagnosticStatus status(std::size_t n) const {
    return outputs.diagnostics.at(n - 1).status.at(0);
  }

  NodeOutputs outputs;
  ros::Publisher source, target;
};

Topics& topics() {
  static Topics topics;
  return topics;
}

std_srvs::Trigger::Response callRegister() {
  std_srvs::Trigger trigger;
  EXPECT_TRUE(ros::service::call("/posture/register", trigger));
  return trigger.response;
}

class RegisterTopics : public testing::Test {
 protected:
  const PointCloud2 source_ = cloudMessage(0, "left", 10), target_ = cloudMessage(6, "right", 20);
  const Points from_ = app::cloudOf(source_).points, to_ = app::cloudOf(target_).points;
  const NodeOutputs& outputs_ = topics().outputs;
};

TEST_F(RegisterTopics, nothingToRegisterYet) {
  const std_srvs::Trigger::Response response = callRegister();
  EXPECT_FALSE(response.success);
  EXPECT_THAT(response.message, testing::HasSubstr("not come"));
}

TEST_F(RegisterTopics, registersPointsOfABody) {
  topics().target.publish(target_);
  topics().source.publish(source_);
  ASSERT_TRUE(outputs_.waitForStatus(1));
  const DiagnosticStatus status = topics().status(1);
  ASSERT_EQ(int{status.level}, int{DiagnosticStatus::OK}) << status.message;
  ASSERT_TRUE(outputs_.waitForResult(1));
  EXPECT_EQ(status.name, "posture/registration: registration");
  EXPECT_GT(valueOf(status, "trust"), 0.5);
  EXPECT_GT(valueOf(status, "share mapped"), 0.9);
  EXPECT_GT(valueOf(status, "parts"), 4);
  EXPECT_GT(valueOf(status, "seconds"), 0);
}

TEST_F(RegisterTopics, keepsPointsAndFieldsAndTakesTheHeaderOfTheTarget) {
  const PointCloud2& registered = outputs_.registered.at(0);
  EXPECT_EQ(registered.header.frame_id, "right");
  EXPECT_EQ(registered.header.stamp, ros::Time(20));
  ASSERT_EQ(registered.width, source_.width);
  EXPECT_EQ(registered.height, 1U);
  EXPECT_FALSE(registered.is_dense);
  ASSERT_EQ(fieldNames(registered), fieldNames(source_));
  ASSERT_EQ(registered.data.size(), source_.data.size());
  const Points moved = app::cloudOf(registered).points;
  for (Eigen::Index i = 0; i < moved.rows(); ++i) {
    const std::size_t own = i * source_.point_step + 12;  // behind x, y, z
    EXPECT_TRUE(std::equal(&source_.data[own], &source_.data[own] + 4, &registered.data[own]));
    EXPECT_EQ(moved.row(i).allFinite(), from_.row(i).allFinite()) << i;
  }
}

TEST_F(RegisterTopics, putsThemOnTheTargetAndOnTheRightSide) {
  const Points moved = app::cloudOf(outputs_.registered.at(0)).points;
  const Points target = to_.topRows(to_.rows() - UNSEEN);
  const double error = meanError(moved, target, BODY + "0-pose6.txt");
  EXPECT_LT(error, 0.015);
  EXPECT_LT(5 * error, meanError(moved, target, BODY + "0-pose6-mirror.txt"));
}

TEST_F(RegisterTopics, linesJoinTruePairs) {
  const Marker& lines = outputs_.correspondences.at(0);
  EXPECT_EQ(lines.header.frame_id, "right");
  EXPECT_EQ(lines.type, Marker::LINE_LIST);
  ASSERT_EQ(lines.points.size(), lines.colors.size());
  ASSERT_GT(lines.points.size(), 2000U);
  ASSERT_LE(lines.points.size(), 4000U);
  std::map<std::array<double, 3>, int> number;
  for (int i = 0; i < from_.rows() - UNSEEN; ++i)
    number[{from_(i, 0), from_(i, 1), from_(i, 2)}] = i;
  std::map<int, int> truth;
  for (const VertexPair& pair : readVertexPairs(BODY + "0-pose6.txt"))
    truth[pair.source] = pair.target;
  double sum = 0;
  int count = 0;
  for (std::size_t k = 0; k < lines.points.size(); k += 2) {
    const geometry_msgs::Point &a = lines.points[k], &b = lines.points[k + 1];
    const auto source = number.find({a.x, a.y, a.z});
    ASSERT_NE(source, number.end()) << "a line begins at no point of the source";
    const auto pair = truth.find(source->second);
    if (pair == truth.end()) continue;
    sum += (Eigen::RowVector3d(b.x, b.y, b.z) - to_.row(pair->second)).norm();
    ++count;
  }
  ASSERT_GT(count, 500);
  const Points target = to_.topRows(to_.rows() - UNSEEN);
  EXPECT_LT(sum / count,
            0.015 * (target.colwise().maxCoeff() - target.colwise().minCoeff()).norm());
}

TEST_F(RegisterTopics, colorsBothSides) {
  const PointCloud2 &source = outputs_.source_colored.at(0),
                    &target = outputs_.target_colored.at(0);
  EXPECT_EQ(source.header.frame_id, "left");
  EXPECT_EQ(target.header.frame_id, "right");
  EXPECT_EQ(source.width, source_.width);
  EXPECT_EQ(target.width, target_.width);
  EXPECT_THAT(fieldNames(source),
              testing::ElementsAre("x", "y", "z", "rgb", "target", "confidence"));
  EXPECT_THAT(fieldNames(target), testing::ElementsAre("x", "y", "z", "rgb"));
}

TEST_F(RegisterTopics, showsSegments) {
  const auto& markers = outputs_.segments.at(0).markers;
  ASSERT_GT(markers.size(), 5U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
  std::size_t points = 0;
  for (std::size_t part = 1; part < markers.size(); ++part) {
    EXPECT_EQ(markers[part].header.frame_id, "left");
    EXPECT_EQ(markers[part].id, static_cast<int>(part) - 1);
    EXPECT_FALSE(markers[part].points.empty());
    points += markers[part].points.size();
  }
  EXPECT_GT(points, 0.9 * (from_.rows() - UNSEEN));
}

TEST_F(RegisterTopics, tellsHowFarItIs) {
  ASSERT_GT(outputs_.progress.size(), 5U);
  for (std::size_t k = 1; k < outputs_.progress.size(); ++k)
    EXPECT_GE(outputs_.progress[k].data, outputs_.progress[k - 1].data);
  EXPECT_FLOAT_EQ(outputs_.progress.back().data, 1);
  EXPECT_EQ(outputs_.stages.front().data, "surfaces");
  EXPECT_EQ(outputs_.stages.back().data, "done");
}

TEST_F(RegisterTopics, badCloudsAreToldAndSurvived) {
  PointCloud2 unseen = cloudMessage(0, "left", 30);
  unseen.data = app::moved(unseen, Points::Constant(unseen.width, 3, NAN), {}).data;
  PointCloud2 truncated = cloudMessage(0, "left", 40);
  truncated.data.resize(truncated.data.size() / 2);
  PointCloud2 no_positions = cloudMessage(0, "left", 50);
  no_positions.fields[1].name = "why";
  std::size_t n = outputs_.diagnostics.size();
  for (const auto& [message, reason] :
       {std::pair(PointCloud2(), "source has no points"),
        std::pair(unseen, "source has no point with finite coordinates"),
        std::pair(truncated, "source has fewer data"),
        std::pair(no_positions, "source has no fields x, y and z")}) {
    topics().source.publish(message);
    ASSERT_TRUE(outputs_.waitForStatus(++n)) << reason;
    EXPECT_EQ(int{topics().status(n).level}, int{DiagnosticStatus::ERROR});
    EXPECT_THAT(topics().status(n).message, testing::HasSubstr(reason));
  }
  EXPECT_EQ(outputs_.registered.size(), 1U) << "something was published for a bad cloud";

  // The service registers once more what came last, which is bad still.
  EXPECT_TRUE(callRegister().success);
  ASSERT_TRUE(outputs_.waitForStatus(++n));
  EXPECT_EQ(topics().status(n).message, topics().status(n - 1).message);
}

TEST_F(RegisterTopics, aGoodCloudIsRegisteredAfterBadOnesTheSameAsBefore) {
  const std::size_t n = outputs_.diagnostics.size();
  topics().source.publish(source_);
  ASSERT_TRUE(outputs_.waitForStatus(n + 1));
  EXPECT_EQ(topics().status(n + 1).message, topics().status(1).message);
  ASSERT_TRUE(outputs_.waitForResult(2));
  EXPECT_EQ(outputs_.registered.at(1).data, outputs_.registered.at(0).data);
}

/// Another node that reads the same clouds, in the namespace /other.
const std::vector<std::string> OTHER = {"__ns:=other",
                                        "__name:=other",
                                        "source:=/posture/source",
                                        "target:=/posture/target",
                                        "/diagnostics:=/other/diagnostics"};

TEST(OtherNode, endsInTheMiddleOfARegistration) {
  bool started = false;
  std::chrono::steady_clock::time_point interrupted;
  const ros::Subscriber progress = topics().outputs.node.subscribe<std_msgs::Float32>(
      "/other/progress",
      10,
      boost::function<void(const std_msgs::Float32ConstPtr&)>(
          [&started](const std_msgs::Float32ConstPtr& message) { started |= message->data > 0; }));
  const auto limit = std::chrono::steady_clock::now() + LONG;
  const ProgramRun ended = runInterrupted(NODE, OTHER, SIGINT, [&] {
    ros::getGlobalCallbackQueue()->callAvailable();
    interrupted = std::chrono::steady_clock::now();
    return started || interrupted > limit;
  });
  EXPECT_TRUE(started) << ended.out << ended.err;
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_LT(std::chrono::steady_clock::now() - interrupted, std::chrono::seconds(10));
}

ProgramRun runOther(const std::string& name, const std::string& parameter) {
  std::vector<std::string> arguments = OTHER;
  arguments[1] = "__name:=" + name;  // parameters stay behind under the name
  arguments.push_back(parameter);
  return run(NODE, arguments);
}

TEST(OtherNode, refusesBadParametersInOneLine) {
  const ProgramRun method = runOther("method", "_method:=icp");
  EXPECT_EQ(method.exit_code, 2);
  EXPECT_TRUE(saidWhyInOneLine(method)) << method.out << method.err;
  EXPECT_THAT(method.err, testing::HasSubstr("~method must be one of paper, refined"));
  const ProgramRun unknown = runOther("unknown", "_methd:=paper");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, testing::HasSubstr("~methd is not known"));
  const ProgramRun missing = runOther("missing", "_source_file:=/nowhere/scan.pcd");
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_TRUE(saidWhyInOneLine(missing)) << missing.out << missing.err;
  EXPECT_THAT(missing.err, testing::HasSubstr("/nowhere/scan.pcd"));
}

}  // namespace
}  // namespace posture::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_register_topics");
  return RUN_ALL_TESTS();
}
