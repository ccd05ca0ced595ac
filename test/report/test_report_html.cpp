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
  return page;
}

std::string samplePage() { return reportHtml(test::sampleResult(), test::sampleRun()); }

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

TEST(ReportHtml, marksTheChosenCandidateAndTheStatus) {
  const std::string page = samplePage();
  EXPECT_EQ(test::countOf(page, "<tr class=\"chosen\">"), 1);
  EXPECT_NE(page.find("<td>+-+</td>"), std::string::npos);
  EXPECT_NE(page.find("Registered."), std::string::npos);
  RegistrationResult undecided = test::sampleResult();
  undecided.status = Status::UNDECIDED;
  EXPECT_NE(reportHtml(undecided, test::sampleRun()).find("Undecided."), std::string::npos);
}

TEST(ReportHtml, showsWhatDecidedBetweenAnswers) {
  RegistrationResult result = test::sampleResult();
  result.hypotheses.clear();
  result.alternatives.resize(2);
  result.chosen = 1;
  result.alternatives[0].score = -9.25;
  result.alternatives[1].score = -9.5;
  result.alternatives[1].refined_score = -10.75;
  result.alternatives[1].let_go = 0.125;
  const std::string page = reportHtml(result, test::sampleRun());
  EXPECT_EQ(test::markupFault(asXml(page)), "");
  const std::string chosen = page.substr(page.find("<tr class=\"chosen\">"));
  const std::string cells = chosen.substr(0, chosen.find("</tr>"));
  for (const char* cell : {"<td>-10.75</td>", "<td>-9.50</td>", "<td>0.125</td>"})
    EXPECT_NE(cells.find(cell), std::string::npos) << cell;
  for (const char* column : {"<th>refined score</th>", "<th>let go</th>"})
    EXPECT_NE(page.find(column), std::string::npos) << column;
}

TEST(ReportHtml, runsDifferInTheLastSectionAlone) {
  RunDescription other = test::sampleRun();
  other.seconds = 99;
  const std::string a = samplePage();
  const std::string b = reportHtml(test::sampleResult(), other);
  const std::size_t last = a.rfind("<h2>");
  EXPECT_NE(a, b);
  EXPECT_EQ(a.substr(0, last), b.substr(0, last));
}

}  // namespace
}  // namespace posture
