// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include <string>
#include <xmlrpcpp/XmlRpcValue.h>

namespace posture::app {

/// The node's private parameters.
struct Parameters {
  RegistrationOptions registration;      ///< ~method, ~surface, ~both_ways
  std::string source_file, target_file;  ///< in place of a topic; empty: the topic
  std::string frame = "map";             ///< of what is read from files
};

/// \param given  a struct, name to value, or no value at all.
/// \throws std::invalid_argument  one line: a name that is not known, or a value out of place.
Parameters parametersFrom(XmlRpc::XmlRpcValue given);

}  // namespace posture::app
