// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/table.h>

#include "benchmark_report.h"
#include <algorithm>
#include <set>

namespace posture::app {
namespace {

using Cells = std::vector<std::string>;

/// "3 of 9", or "-" where nothing was counted.
std::string countOf(const Json& json, const char* count, const char* of) {
  const int whole = json.value(of, 0);
  return whole == 0 ? "-" : std::to_string(json.value(count, 0)) + " of " + std::to_string(whole);
}

std::string yesNo(const Json& json, const char* pointer) {
  const Json::json_pointer place(pointer);
  if (!json.contains(place)) return "-";
  return json.at(place) == true ? "yes" : "no";
}

std::string familyTable(const Json& families) {
  std::vector<Cells> rows;
  rows.reserve(families.size());
  for (const Json& f : families)
    rows.push_back({textAt(f, "family"),
                    std::to_string(f.value("pairs", 0)),
                    std::to_string(f.value("failed", 0) + f.value("not_run", 0)),
                    formatFixed(numberAt(f, "/mean_mean_x100"), 2),
                    formatFixed(numberAt(f, "/median_mean_x100"), 2),
                    formatFixed(numberAt(f, "/largest_mean_x100"), 2),
                    formatFixed(numberAt(f, "/mean_subvertex_x100"), 2),
                    countOf(f, "chose_wrong", "compared"),
                    formatFixed(numberAt(f, "/median_best_x100"), 2),
                    formatFixed(numberAt(f, "/largest_best_x100"), 2),
                    countOf(f, "wrong_side", "mirror_known"),
                    formatPercent(numberAt(f, "/mean_share_accepted")),
                    formatPercent(numberAt(f, "/median_share_within_two_edges")),
                    formatFixed(numberAt(f, "/median_seconds"), 1),
                    formatFixed(numberAt(f, "/largest_seconds"), 1),
                    formatFixed(numberAt(f, "/largest_memory_mib"), 0)});
  return toMarkdown({{"family",
                      "pairs",
                      "no result",
                      "error, mean",
                      "error, median",
                      "error, largest",
                      "sub-vertex, mean",
                      "chose wrong",
                      "best, median",
                      "best, largest",
                      "wrong side",
                      "mapped",
                      "within 2 edges",
                      "s, median",
                      "s, largest",
                      "MiB, largest"},
                     rows}) +
         "\nError of a pair: mean over its mapped points of the geodesic distance on the target "
         "from the vertex found to the true vertex, divided by the square root of the target's "
         "area, times 100; sub-vertex: from the place found in a face. Chose wrong: of the answers "
         "the method compared, another one's error is less by more than 2 and by more than a "
         "third. Best: the error of the best of these answers, on at most 1,000 evenly spread true "
         "pairs (the refined method compares them on coarse meshes, so its final map is better); "
         "an answer counts when it maps at least a quarter as many of them as the one that maps "
         "most. Wrong side: the map is nearer to the left-right mirrored answer than to the true "
         "one, where both are known. Mapped: share of the source's vertices with a counterpart. "
         "Within 2 edges: share of the mapped points at most two edges from the true vertex. "
         "No result: not run (the input is not supported) or failed; the reason is in the table "
         "of pairs. Seconds include reading the files; memory is the peak of the process that "
         "registered the pair.\n";
}

std::string trustSection(const TrustCurve& trust) {
  if (!trust.isKnown()) return {};
  return "\n## Trust\n\nOver " + std::to_string(trust.good) + " good maps (error below 5) and " +
         std::to_string(trust.bad) +
         " bad ones (worse, or of unrelated shapes) the trust figure has an area under the ROC "
         "curve of **" +
         formatFixed(trust.area(), 3) + "**. At the threshold of the status, 0.5, " +
         formatPercent(trust.goodAbove(0.5)) + " of the good maps and " +
         formatPercent(trust.badAbove(0.5)) +
         " of the bad ones are called registered.\n\n![ROC of the trust figure](trust.svg)\n";
}

struct PaperRow {
  const char* family;  ///< ours of the same shapes; empty: we do not have them
  Cells cells;         ///< shapes, vertices, samples, accepted, rejected, within 2 edges, time
};

/// Section 6.1 of Wuhrer, Shu and Bose 2009. What it does not say is "-".
const std::vector<PaperRow>& paperRows() {
  static const std::vector<PaperRow> ROWS{
      {"", {"alien a-b", "6858", "-", "1094", "5764", "large errors", "35 min"}},
      {"", {"alien a-c", "6858", "-", "2148", "4710", "nearly all", "35 min"}},
      {"", {"alien a-d", "6858", "-", "1928", "4930", "nearly all", "35 min"}},
      {"cat", {"cat", "7207", "2000", "-", "-", "-", "< 10 min"}},
      {"horse", {"horse", "8431", "2000", "-", "-", "-", "< 10 min"}},
      {"gorilla", {"gorilla", "2028-2046", "1000", "-", "-", "-", "< 10 min"}},
      {"centaur", {"centaur", "3400", "1000", "-", "-", "-", "< 10 min"}},
      {"holes", {"many small holes", "21338, 25658", "2050", "-", "-", "-", "80 min"}}};
  return ROWS;
}

bool isOfThePaper(const Json& family) {
  return family.value("run", 0) > 0 &&
         std::any_of(paperRows().begin(), paperRows().end(), [&](const PaperRow& row) {
           return *row.family != '\0' && row.family == textAt(family, "family");
         });
}

Cells ourRow(const Json& f) {
  return {textAt(f, "family"),
          "ours",
          formatFixed(numberAt(f, "/source_vertices"), 0),
          formatFixed(numberAt(f, "/samples"), 0),
          formatFixed(numberAt(f, "/median_accepted"), 0),
          formatFixed(numberAt(f, "/median_rejected"), 0),
          formatPercent(numberAt(f, "/median_share_within_two_edges")),
          formatFixed(numberAt(f, "/median_seconds"), 1) + " s"};
}

std::string paperTable(const Json& families) {
  std::vector<Cells> rows;
  std::set<std::string> shown;
  for (const PaperRow& paper : paperRows()) {
    rows.push_back(paper.cells);
    rows.back().insert(rows.back().begin() + 1, "paper");
    for (const Json& f : families)
      if (*paper.family != '\0' && textAt(f, "family") == paper.family && f.value("run", 0) > 0) {
        rows.push_back(ourRow(f));
        shown.insert(paper.family);
      }
  }
  for (const Json& f : families)
    if (shown.count(f.value("family", "")) == 0 && f.value("run", 0) > 0) rows.push_back(ourRow(f));
  return toMarkdown({{"shapes",
                      "whose",
                      "vertices",
                      "samples",
                      "accepted",
                      "rejected",
                      "within 2 edges",
                      "time"},
                     rows}) +
         "\nThe paper's figures are those of its section 6.1, for single pairs; accepted is its "
         "vertices less those it rejected. Its alien and its shapes with holes are not in our "
         "list; "
         "our family of holes has large holes and noise, too. Ours are medians over the pairs of a "
         "family. The error in edges is the least number of edges of the target between the vertex "
         "found and the true one; rejected points have none.\n";
}

std::string pairTable(const std::vector<Json>& results) {
  std::vector<Cells> rows;
  rows.reserve(results.size());
  for (const Json& r : results)
    rows.push_back({textAt(r, "id"),
                    textAt(r, "status"),
                    formatFixed(numberAt(r, "/source_vertices"), 0),
                    formatFixed(numberAt(r, "/target_vertices"), 0),
                    formatFixed(numberAt(r, "/errors/mean_x100"), 2),
                    formatFixed(numberAt(r, "/errors/median_x100"), 2),
                    formatFixed(numberAt(r, "/subvertex_mean_x100"), 2),
                    formatFixed(numberAt(r, "/candidates/chosen_mean_x100"), 2),
                    formatFixed(numberAt(r, "/candidates/best_mean_x100"), 2),
                    yesNo(r, "/candidates/chose_wrong"),
                    formatFixed(numberAt(r, "/trust"), 3),
                    yesNo(r, "/mirror/wrong_side"),
                    formatFixed(numberAt(r, "/accepted"), 0),
                    formatFixed(numberAt(r, "/rejected"), 0),
                    formatPercent(numberAt(r, "/errors/share_within_two_edges")),
                    formatFixed(numberAt(r, "/seconds"), 1),
                    formatFixed(numberAt(r, "/peak_memory_mib"), 0),
                    textAt(r, "message")});
  return toMarkdown({{"pair",
                      "status",
                      "source",
                      "target",
                      "error",
                      "median",
                      "sub-vertex",
                      "chosen, sampled",
                      "best, sampled",
                      "chose wrong",
                      "trust",
                      "wrong side",
                      "accepted",
                      "rejected",
                      "within 2 edges",
                      "s",
                      "MiB",
                      "message"},
                     rows}) +
         "\nError and median are those of the whole map; \"sampled\" ones those of the answers "
         "compared, on at most 1,000 pairs. Maps far from the truth on large meshes are measured "
         "on "
         "a "
         "part of the pairs: `measured_pairs` in results.json.\n";
}

/// How the deformed source sits on the target: all there is to say without a truth.
std::string fitTable(const std::vector<Json>& results) {
  std::vector<Cells> rows;
  for (const Json& r : results)
    if (r.contains("fit") && !r.contains("errors"))
      rows.push_back({textAt(r, "id"),
                      formatPercent(numberAt(r, "/accepted") / numberAt(r, "/source_vertices")),
                      formatFixed(numberAt(r, "/fit/median_distance"), 2),
                      formatFixed(numberAt(r, "/fit/percentile_95_distance"), 2),
                      formatFixed(numberAt(r, "/fit/mean_stretch"), 3),
                      formatFixed(numberAt(r, "/fit/percentile_95_stretch"), 3)});
  if (rows.empty()) return {};
  return "\n## Pairs without a truth\n\n" +
         toMarkdown({{"pair",
                      "accepted",
                      "distance, median",
                      "distance, 95 %",
                      "stretch, mean",
                      "stretch, 95 %"},
                     rows}) +
         "\nDistance: from the deformed source's vertices to the nearest vertex of the target, in "
         "mean edge lengths of the target. Stretch: |log| of an edge's length after and before.\n";
}

std::string stageTable(const Json& families) {
  Cells stages;
  for (const Json& f : families)
    for (const auto& stage : f["stages"].items())
      if (std::find(stages.begin(), stages.end(), stage.key()) == stages.end())
        stages.push_back(stage.key());
  if (stages.empty()) return {};
  std::vector<Cells> rows;
  for (const Json& f : families) {
    if (f.value("run", 0) == 0) continue;
    Cells row{textAt(f, "family")};
    for (const std::string& stage : stages)
      row.push_back(formatFixed(numberAt(f, "/stages/" + stage), 2));
    rows.push_back(row);
  }
  Cells header{"family"};
  for (const std::string& stage : stages) header.push_back(stage);
  return "\n## Seconds by stage\n\n" + toMarkdown({header, rows}) +
         "\nMedians over the pairs, of the attempt on the surfaces as given, which goes on to "
         "annealing and "
         "what follows only where it is taken; what further attempts took, where there were any, "
         "is in results.json.\n";
}

}  // namespace

std::string benchmarkPage(const std::vector<Json>& results,
                          const Json& families,
                          const TrustCurve& trust,
                          std::size_t listed) {
  double threads = 0;
  for (const Json& r : results) threads = std::max(threads, r.value("threads", 0.0));
  std::string page = "# Benchmark\n\n" + std::to_string(results.size()) + " of the list's " +
                     std::to_string(listed) + " pairs, posture " POSTURE_VERSION;
  if (threads > 0) page += ", " + formatFixed(threads, 0) + " threads";
  const bool paper = !results.empty() && results.front().value("method", "") == "paper";
  page += paper ? ", the method as published" : ", the refined method";
  page += ".\n\n## Families\n\n" + familyTable(families);
  page +=
      "\n![Share of points with error below x](curves.svg)\n\n"
      "![Share of accepted points by error in edges](histogram.svg)\n";
  page += trustSection(trust);
  if (std::any_of(families.begin(), families.end(), isOfThePaper))
    page += "\n## The paper's own figures\n\n" + paperTable(families);
  page += "\n## Pairs\n\n" + pairTable(results);
  return page + fitTable(results) + stageTable(families);
}

}  // namespace posture::app
