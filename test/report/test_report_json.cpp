// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/report_json.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <report/sample_result.h>

namespace posture {
namespace {

nlohmann::ordered_json sampleReport(const RunDescription& run = test::sampleRun()) {
  return nlohmann::ordered_json::parse(reportJson(test::sampleResult(), run));
}

TEST(ReportJson, saysWhatWasFound) {
  const auto report = sampleReport();
  EXPECT_EQ(report.at("status"), "registered");
  EXPECT_EQ(report.at("message"), test::sampleResult().message);
  EXPECT_EQ(report.at("trust").at("accepted_vertices"), 3);
  EXPECT_EQ(report.at("trust").at("accepted_share"), 0.75);
  EXPECT_EQ(report.at("trust").at("mean_confidence_of_accepted"), 0.5);
  EXPECT_EQ(report.at("trust").at("runner_up_energy_ratio"), 2.5);
  EXPECT_EQ(report.at("scale_source_to_target"), 1.5);
  EXPECT_EQ(report.at("consistency_threshold_c0"), 0.75);
  EXPECT_EQ(report.at("source").at("file"), "a<b>.ply");
  EXPECT_EQ(report.at("source").at("cleaning").at("welded_vertices"), 6);
  EXPECT_EQ(report.at("target").at("main_surface").at("boundary_edges"), 12);
  EXPECT_EQ(report.at("options").at("paper"), "true");
  EXPECT_EQ(report.at("files").size(), 1u);
  EXPECT_FALSE(report.at("versions").at("ceres").get<std::string>().empty());
  EXPECT_FALSE(report.at("versions").at("pcl").get<std::string>().empty());
}

TEST(ReportJson, hypothesesWithNullForWhatIsNotFinite) {
  const auto hypotheses = sampleReport().at("hypotheses");
  ASSERT_EQ(hypotheses.size(), 3u);
  EXPECT_EQ(hypotheses[0].at("chosen"), true);
  EXPECT_EQ(hypotheses[1].at("axis_signs"), (std::vector<int>{1, -1, 1}));
  EXPECT_EQ(hypotheses[1].at("energy_E_D"), 5.0);
  EXPECT_TRUE(hypotheses[1].at("assignment_cost_E_H").is_null());
  EXPECT_TRUE(hypotheses[2].at("energy_E_D").is_null());
}

TEST(ReportJson, runsDifferInTheLastObjectAlone) {
  RunDescription other = test::sampleRun();
  other.seconds = 99;
  other.threads = 1;
  auto a = sampleReport(), b = sampleReport(other);
  EXPECT_EQ((--a.end()).key(), "run");
  EXPECT_EQ(a.at("run").at("stages").size(), 2u);
  EXPECT_GT(a.at("run").at("peak_memory_bytes"), 1000000);
  EXPECT_NE(a, b);
  a.erase("run");
  b.erase("run");
  EXPECT_EQ(a, b);
}

TEST(ReportJson, pointsThatAreMissingCountForNothing) {
  RegistrationResult result = test::sampleResult();
  result.source_scan.emplace();
  result.source_scan->summary.missing = 1;
  const auto trust = nlohmann::json::parse(reportJson(result, {})).at("trust");
  EXPECT_EQ(trust.at("source_vertices"), 3);
  EXPECT_EQ(trust.at("accepted_vertices"), 3);
  EXPECT_EQ(trust.at("accepted_share"), 1.0);
}

TEST(ReportJson, emptyResult) {
  RegistrationResult nothing;
  const auto report = nlohmann::json::parse(reportJson(nothing, {}));
  EXPECT_EQ(report.at("status"), "undecided");
  EXPECT_TRUE(report.at("chosen").is_null());
  EXPECT_TRUE(report.at("trust").at("accepted_share").is_null());
  EXPECT_EQ(report.at("alternatives").size(), 0u);
}

TEST(ReportJson, eachMethodHasItsOwnFields) {
  const auto published = sampleReport();
  EXPECT_FALSE(published.contains("alternatives"));
  RegistrationResult result = test::sampleResult();
  result.hypotheses.clear();
  result.alternatives.resize(2);
  const auto refined = nlohmann::json::parse(reportJson(result, {}));
  EXPECT_EQ(refined.at("alternatives").size(), 2u);
  for (const char* field : {"hypotheses", "consistency_threshold_c0"})
    EXPECT_FALSE(refined.contains(field)) << field;
  EXPECT_FALSE(refined.at("trust").contains("runner_up_energy_ratio"));
}

TEST(ReportJson, fileNamesNeedNotBeUtf8) {
  RunDescription run = test::sampleRun();
  run.source = "\xff.ply";
  EXPECT_NO_THROW(sampleReport(run));
}

}  // namespace
}  // namespace posture
