// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>

#include "common/exit.h"
#include "registration_node.h"
#include <cstdio>
#include <exception>
#include <glog/logging.h>
#include <new>

namespace {

using posture::app::EXIT_INPUT;
using posture::app::EXIT_USAGE;

int fail(const char* message, int exit_code) noexcept {
  return posture::app::fail("posture_node", message, exit_code);
}

int run() {
  XmlRpc::XmlRpcValue given;
  ros::param::get(ros::this_node::getName(), given);
  const posture::app::RegistrationNode node(posture::app::parametersFrom(given));
  ros::spin();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // what Ceres thinks of a line search is not for the user
  try {
    ros::init(argc, argv, "posture");
    return run();
  } catch (const std::invalid_argument& error) {
    return fail(error.what(), EXIT_USAGE);
  } catch (const posture::InputError& error) {
    return fail(error.what(), EXIT_INPUT);
  } catch (const std::bad_alloc&) {
    return fail("the input does not fit into memory", EXIT_INPUT);
  } catch (const std::exception& error) {
    return fail(error.what(), EXIT_INPUT);
  }
}
