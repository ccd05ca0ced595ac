// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node_outputs.h"

#include <posture/io/correspondence_io.h>

#include <algorithm>
#include <limits>
#include <ros/callback_queue.h>
#include <stdexcept>

namespace posture::test {

bool waitFor(const std::function<bool()>& condition, std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (!ros::ok() || std::chrono::steady_clock::now() > end) return false;
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
  }
  return true;
}

template <class Message>
void NodeOutputs::collect(const std::string& topic, Messages<Message>& messages) {
  using Pointer = boost::shared_ptr<const Message>;
  const auto add = [&messages](const Pointer& message) { messages.push_back(*message); };
  subscribers.push_back(
      node.subscribe<Message>(topic, 1000, boost::function<void(const Pointer&)>(add)));
}

NodeOutputs::NodeOutputs() {
  collect("/diagnostics", diagnostics);
  collect("/posture/registered", registered);
  collect("/posture/source_colored", source_colored);
  collect("/posture/target_colored", target_colored);
  collect("/posture/correspondences", correspondences);
  collect("/posture/segments", segments);
  collect("/posture/progress", progress);
  collect("/posture/stage", stages);
  const bool connected = waitFor([this] {
    return std::all_of(subscribers.begin(), subscribers.end(), [](const ros::Subscriber& topic) {
      return topic.getNumPublishers() > 0;
    });
  });
  if (!connected) throw std::runtime_error("the node does not publish what it should");
}

bool NodeOutputs::waitForResult(std::size_t n) const {
  // Each topic has a connection of its own: what was published first may come last.
  return waitFor([&] {
    const auto ended =
        std::count_if(progress.begin(), progress.end(), [](const auto& p) { return p.data == 1; });
    const auto done =
        std::count_if(stages.begin(), stages.end(), [](const auto& s) { return s.data == "done"; });
    return std::min({registered.size(),
                     source_colored.size(),
                     target_colored.size(),
                     correspondences.size(),
                     segments.size(),
                     static_cast<std::size_t>(ended),
                     static_cast<std::size_t>(done)}) >= n;
  });
}

bool NodeOutputs::waitForStatus(std::size_t n) const {
  return waitFor([&] { return diagnostics.size() >= n; });
}

double valueOf(const diagnostic_msgs::DiagnosticStatus& status, const std::string& key) {
  for (const auto& entry : status.values)
    if (entry.key == key) return std::stod(entry.value);
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> fieldNames(const sensor_msgs::PointCloud2& message) {
  std::vector<std::string> names;
  for (const auto& field : message.fields) names.push_back(field.name);
  return names;
}

double meanError(const Points& placed, const Points& target, const std::string& pairs_file) {
  const std::vector<VertexPair> pairs = readVertexPairs(pairs_file);
  double sum = 0;
  for (const VertexPair& pair : pairs)
    sum += (placed.row(pair.source) - target.row(pair.target)).norm();
  return sum / static_cast<double>(pairs.size()) /
         (target.colwise().maxCoeff() - target.colwise().minCoeff()).norm();
}

}  // namespace posture::test
