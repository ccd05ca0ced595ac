// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <chrono>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <functional>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Float32.h>
#include <std_msgs/String.h>
#include <string>
#include <vector>
#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

namespace posture::test {

/// Long enough for a machine that is busy with other tests.
inline constexpr std::chrono::minutes LONG(8);

/// Handles callbacks until the condition holds. false: it never did.
bool waitFor(const std::function<bool()>& condition, std::chrono::seconds limit = LONG);

/// All messages of a topic that have come.
template <class Message>
using Messages = std::vector<Message>;

/// What the node in the namespace /posture has published since this object was made, and the last
/// of before.
struct NodeOutputs {
  /// Returns when all topics are connected. \throws std::runtime_error  they never were.
  NodeOutputs();

  /// Waits until n registrations that found something have been published whole.
  bool waitForResult(std::size_t n) const;
  bool waitForStatus(std::size_t n) const;

  ros::NodeHandle node;
  Messages<diagnostic_msgs::DiagnosticArray> diagnostics;
  Messages<sensor_msgs::PointCloud2> registered, source_colored, target_colored;
  Messages<visualization_msgs::Marker> correspondences;
  Messages<visualization_msgs::MarkerArray> segments;
  Messages<std_msgs::Float32> progress;
  Messages<std_msgs::String> stages;
  std::vector<ros::Subscriber> subscribers;

 private:
  template <class Message>
  void collect(const std::string& topic, Messages<Message>& messages);
};

/// Value of a key as a number; NaN: there is none.
double valueOf(const diagnostic_msgs::DiagnosticStatus& status, const std::string& key);

std::vector<std::string> fieldNames(const sensor_msgs::PointCloud2& message);

/// Mean distance between corresponding rows of pairs "source target", over the diagonal of the box
/// around the target.
double meanError(const Points& placed, const Points& target, const std::string& pairs_file);

}  // namespace posture::test
