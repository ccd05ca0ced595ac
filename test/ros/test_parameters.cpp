// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "parameters.h"
#include <stdexcept>

namespace posture::app {
namespace {

using XmlRpc::XmlRpcValue;

TEST(Parameters, nothingGivenIsWhatTheLibraryDoes) {
  const Parameters parameters = parametersFrom({});
  const RegistrationOptions options;
  EXPECT_EQ(parameters.registration.method, options.method);
  EXPECT_EQ(parameters.registration.surface, options.surface);
  EXPECT_EQ(parameters.registration.both_ways, options.both_ways);
  EXPECT_EQ(parameters.source_file + parameters.target_file, "");
}

TEST(Parameters, areTaken) {
  XmlRpcValue given;
  given["source_file"] = "a.ply";
  given["target_file"] = "b.ply";
  given["frame"] = "base";
  given["surface"] = "greedy";
  given["both_ways"] = true;
  given["method"] = "refined";
  const Parameters parameters = parametersFrom(given);
  EXPECT_EQ(parameters.source_file, "a.ply");
  EXPECT_EQ(parameters.target_file, "b.ply");
  EXPECT_EQ(parameters.frame, "base");
  EXPECT_EQ(parameters.registration.surface, SurfaceMethod::GREEDY);
  EXPECT_TRUE(parameters.registration.both_ways);
  XmlRpcValue paper;
  paper["method"] = "paper";
  EXPECT_EQ(parametersFrom(paper).registration.method, Method::PAPER);
}

/// What is said of one parameter; empty: it is taken.
std::string refusal(const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue given;
  given[name] = value;
  try {
    parametersFrom(given);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Parameters, badOnesAreNamed) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal("method", "icp"), HasSubstr("~method must be one of paper, refined"));
  EXPECT_THAT(refusal("method", 3), HasSubstr("~method must be one of"));
  EXPECT_THAT(refusal("surface", "Delaunay"), HasSubstr("~surface"));
  EXPECT_THAT(refusal("both_ways", "yes"), HasSubstr("~both_ways must be true or false"));
  EXPECT_THAT(refusal("source_file", 7), HasSubstr("~source_file must be a text"));
  EXPECT_THAT(refusal("methd", "paper"), HasSubstr("~methd is not known"));
  XmlRpcValue both;
  both["method"] = "paper";
  both["both_ways"] = true;
  EXPECT_THROW(parametersFrom(both), std::invalid_argument);
}

}  // namespace
}  // namespace posture::app
