// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "registration_node.h"

#include <posture/core/error.h>
#include <posture/core/seconds_since.h>
#include <posture/io/shape_io.h>

#include "cloud_message.h"
#include "result_messages.h"
#include <chrono>
#include <cstdlib>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <new>
#include <std_msgs/Float32.h>
#include <std_msgs/String.h>

namespace posture::app {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointCloud2ConstPtr;

/// Thrown out of a registration that nobody waits for any more.
struct Abandoned {};

Side sideOfFile(const std::string& path, const std::string& frame) {
  auto shape = std::make_shared<Shape>(readShape(path));
  if (shape->faces.rows() > 0) shape->cloud.normals.resize(0, 3);  // a mesh has them in its faces
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = ros::Time::now();
  return {boost::make_shared<PointCloud2>(messageOf(shape->cloud, header)), shape};
}

std::shared_ptr<const Shape> shapeOf(const std::string& name, const Side& side) {
  if (side.shape) return side.shape;
  return naming(name, [&] {
    auto shape = std::make_shared<Shape>();
    shape->cloud = cloudOf(*side.message);
    return shape;
  });
}

void inform(const std::string& message) { ROS_INFO_STREAM(message); }
void warn(const std::string& message) { ROS_WARN_STREAM(message); }

}  // namespace

RegistrationNode::RegistrationNode(const Parameters& parameters) : parameters_(parameters) {
  if (const std::string& file = parameters.source_file; !file.empty())
    pair_.setSource(sideOfFile(file, parameters.frame));
  if (const std::string& file = parameters.target_file; !file.empty())
    pair_.setTarget(sideOfFile(file, parameters.frame));
  advertise();
  subscribe();
  worker_ = std::async(std::launch::async, [this] { work(); });
}

RegistrationNode::~RegistrationNode() {
  pair_.close();
  // The worker looks up between two stages. A stage of a large scan can be long, and nothing is
  // lost with it.
  constexpr std::chrono::seconds PATIENCE(2);
  if (worker_.wait_for(PATIENCE) != std::future_status::ready) std::_Exit(EXIT_SUCCESS);
}

void RegistrationNode::advertise() {
  constexpr bool LATCHED = true;
  registered_ = node_.advertise<PointCloud2>("registered", 1, LATCHED);
  source_colored_ = node_.advertise<PointCloud2>("source_colored", 1, LATCHED);
  target_colored_ = node_.advertise<PointCloud2>("target_colored", 1, LATCHED);
  correspondences_ = node_.advertise<visualization_msgs::Marker>("correspondences", 1, LATCHED);
  segments_ = node_.advertise<visualization_msgs::MarkerArray>("segments", 1, LATCHED);
  diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10, LATCHED);
  progress_ = node_.advertise<std_msgs::Float32>("progress", 10, LATCHED);
  stage_ = node_.advertise<std_msgs::String>("stage", 10, LATCHED);
}

void RegistrationNode::subscribe() {
  using Callback = boost::function<void(const PointCloud2ConstPtr&)>;
  if (parameters_.source_file.empty())
    source_ = node_.subscribe<PointCloud2>(
        "source", 1, Callback([this](const PointCloud2ConstPtr& message) {
          pair_.setSource({message, nullptr});
        }));
  if (parameters_.target_file.empty())
    target_ = node_.subscribe<PointCloud2>(
        "target", 1, Callback([this](const PointCloud2ConstPtr& message) {
          pair_.setTarget({message, nullptr});
        }));
  service_ = node_.advertiseService("register", &RegistrationNode::onRegister, this);
}

bool RegistrationNode::onRegister(std_srvs::Trigger::Request&,
                                  std_srvs::Trigger::Response& response) {
  response.success = pair_.again();
  response.message = response.success ? "the newest source and target will be registered"
                                      : "a source or a target has not come yet";
  return true;
}

void RegistrationNode::work() {
  while (const std::optional<Pair> pair = pair_.take()) {
    try {
      registerPair(*pair);
    } catch (const Abandoned&) {
      if (!pair_.closed()) inform("given up for the newer pair");
    } catch (const std::bad_alloc&) {
      publishStatus(failure("the clouds do not fit into memory"));
    } catch (const std::exception& error) {
      publishStatus(failure(error.what()));
    }
  }
}

void RegistrationNode::registerPair(const Pair& pair) {
  const auto start = std::chrono::steady_clock::now();
  const std::shared_ptr<const Shape> source_shape = shapeOf("source", pair.source),
                                     target_shape = shapeOf("target", pair.target);
  const SideView source{*pair.source.message, *source_shape},
      target{*pair.target.message, *target_shape};
  const RegistrationResult result = registerShapes(
      source.shape, target.shape, parameters_.registration, [this](const StageEvent& event) {
        if (pair_.closed() || pair_.outdated()) throw Abandoned();
        publishProgress(stageTitle(event.attempt, event.stage), event.progress);
      });
  std::optional<ShapeSegments> segments;
  try {
    if (result.status == Status::REGISTERED) segments = segmentShape(source.shape, {result});
  } catch (const std::exception& error) {  // what took minutes is not lost for it
    warn(std::string("without near-rigid parts: ") + error.what());
  }
  const ShapeSegments* const parts = segments ? &*segments : nullptr;

  registered_.publish(registeredCloud(source, target, result));
  source_colored_.publish(coloredSource(source, result));
  target_colored_.publish(coloredTarget(source, target, result));
  correspondences_.publish(correspondenceLines(source, target, result));
  segments_.publish(segmentMarkers(source, result, parts));
  publishProgress("done", 1);
  publishStatus(outcome(result, parts, secondsSince(start)));
}

void RegistrationNode::publishProgress(std::string_view stage, double progress) const {
  std_msgs::String name;
  name.data = std::string(stage);
  stage_.publish(name);
  std_msgs::Float32 value;
  value.data = static_cast<float>(progress);
  progress_.publish(value);
}

void RegistrationNode::publishStatus(diagnostic_msgs::DiagnosticStatus status) const {
  using Level = diagnostic_msgs::DiagnosticStatus;
  if (status.level == Level::OK)
    inform(status.message);
  else if (status.level == Level::WARN)
    warn(status.message);
  else
    ROS_ERROR_STREAM(status.message);
  status.name = ros::this_node::getName().substr(1) + ": registration";
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  array.status.push_back(status);
  diagnostics_.publish(array);
}

}  // namespace posture::app
