// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include "common/surface_methods.h"
#include <map>
#include <stdexcept>

namespace posture::app {
namespace {

using XmlRpc::XmlRpcValue;

[[noreturn]] void refuse(const std::string& name, const std::string& expected) {
  throw std::invalid_argument("parameter ~" + name + " must be " + expected);
}

std::string text(const std::string& name, XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeString) refuse(name, "a text");
  return value;
}

bool truth(const std::string& name, XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeBoolean) refuse(name, "true or false");
  return value;
}

template <class Choice>
Choice oneOf(const std::string& name,
             XmlRpcValue& value,
             const std::map<std::string, Choice>& choices) {
  std::string names;
  for (const auto& [choice, meaning] : choices) names += (names.empty() ? "" : ", ") + choice;
  if (value.getType() == XmlRpcValue::TypeString)
    if (const auto found = choices.find(value); found != choices.end()) return found->second;
  refuse(name, "one of " + names);
}

}  // namespace

// NOLINTNEXTLINE(performance-unnecessary-value-param): its members are read by what is not const
Parameters parametersFrom(XmlRpcValue given) {
  Parameters parameters;
  if (!given.valid()) return parameters;
  for (auto& [name, value] : given) {
    if (name == "source_file")
      parameters.source_file = text(name, value);
    else if (name == "target_file")
      parameters.target_file = text(name, value);
    else if (name == "frame")
      parameters.frame = text(name, value);
    else if (name == "both_ways")
      parameters.registration.both_ways = truth(name, value);
    else if (name == "method")
      parameters.registration.method =
          oneOf<Method>(name, value, {{"refined", Method::REFINED}, {"paper", Method::PAPER}});
    else if (name == "surface")
      parameters.registration.surface = oneOf<SurfaceMethod>(name, value, SURFACE_METHODS);
    else
      throw std::invalid_argument("parameter ~" + name + " is not known");
  }
  if (parameters.registration.both_ways && parameters.registration.method == Method::PAPER)
    refuse("both_ways", "false with the method \"paper\"");
  return parameters;
}

}  // namespace posture::app
