// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "newest_pair.h"
#include "parameters.h"
#include <diagnostic_msgs/DiagnosticStatus.h>
#include <future>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <string_view>

namespace posture::app {

/// Registers the newest source to the newest target in a thread of its own, and publishes what
/// comes out. The callbacks hand over and return.
class RegistrationNode {
 public:
  /// \throws InputError  a file that the parameters name cannot be read.
  explicit RegistrationNode(const Parameters& parameters);

  /// Ends the registration that is going on.
  ~RegistrationNode();
  RegistrationNode(const RegistrationNode&) = delete;
  RegistrationNode& operator=(const RegistrationNode&) = delete;

 private:
  void advertise();
  void subscribe();
  bool onRegister(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  void work();
  void registerPair(const Pair& pair);
  void publishProgress(std::string_view stage, double progress) const;
  void publishStatus(diagnostic_msgs::DiagnosticStatus status) const;

  Parameters parameters_;
  NewestPair pair_;
  ros::NodeHandle node_;
  ros::Subscriber source_, target_;
  ros::ServiceServer service_;
  ros::Publisher registered_, source_colored_, target_colored_, correspondences_, segments_;
  ros::Publisher diagnostics_, progress_, stage_;
  std::future<void> worker_;
};

}  // namespace posture::app
