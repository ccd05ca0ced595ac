// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/report_html.h>

#include <gtest/gtest.h>

#include <report/markup_checks.h>
#include <report/sample_result.h>

namespace posture {
namespace {

/// The page as XML: tags that HTML leaves open are closed.
std::string asXml(std::string page) {
  const std::string meta = "<meta charset=\"utf-8\"";
  page.replace(page.find(meta) + meta.size(), 1, "/>");
  for (std::size_t i = page.find("<img "); i != std::string::npos; i = page.find("<img ", i + 1))
    page.replace(page.find('>', i), 1, "/>");
  return page;
}

std::string samplePage() {
  return reportHtml(test::sampleResult(),
                    test::sampleRun(),
                    {{"Beside \"each\" other", "pictures/side.png", ""}, {"Within", "", "Man"}});
}

TEST(ReportHtml, isWellFormedAndEscaped) {
  const std::string page = samplePage();
  EXPECT_EQ(test::markupFault(asXml(page)), "");
  EXPECT_NE(page.find("a&lt;b&gt;.ply"), std::string::npos);
  EXPECT_NE(page.find("&lt;found&gt; &amp; &quot;kept&quot;"), std::string::npos);
}

TEST(ReportHtml, needsNothingFromElsewhere) {
  const std::string page = samplePage();
  for (const char* outside : {"http", "<link", "<script", "@import", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

TEST(ReportHtml, picturesInsideOrBeside) {
  const std::string page = samplePage();
  EXPECT_NE(page.find("src=\"pictures/side.png\""), std::string::npos);
  EXPECT_NE(page.find("src=\"data:image/png;base64,TWFu\""), std::string::npos);
  const auto embedded = [](const std::string& bytes) {
    return reportHtml({}, {}, {{"", "", bytes}});
  };
  EXPECT_NE(embedded("Ma").find("base64,TWE=\""), std::string::npos);
  EXPECT_NE(embedded("M\xff").find("base64,Tf8=\""), std::string::npos);
  EXPECT_NE(embedded("M").find("base64,TQ==\""), std::string::npos);
}

TEST(ReportHtml, marksTheChosenCandidateAndTheStatus) {
  const std::string page = samplePage();
  EXPECT_EQ(test::countOf(page, "<tr class=\"chosen\">"), 1);
  EXPECT_NE(page.find("<td>+-+</td>"), std::string::npos);
  EXPECT_NE(page.find("Registered."), std::string::npos);
  RegistrationResult undecided = test::sampleResult();
  undecided.status = Status::UNDECIDED;
  EXPECT_NE(reportHtml(undecided, test::sampleRun()).find("Undecided."), std::string::npos);
}

TEST(ReportHtml, runsDifferInTheLastSectionAlone) {
  RunDescription other = test::sampleRun();
  other.seconds = 99;
  const std::string a = samplePage();
  const std::string b =
      reportHtml(test::sampleResult(),
                 other,
                 {{"Beside \"each\" other", "pictures/side.png", ""}, {"Within", "", "Man"}});
  const std::size_t last = a.rfind("<h2>");
  EXPECT_NE(a, b);
  EXPECT_EQ(a.substr(0, last), b.substr(0, last));
}

}  // namespace
}  // namespace posture
