// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/peak_memory.h>
#include <posture/report/report_html.h>
#include <posture/report/table.h>

#include "markup.h"
#include <algorithm>

namespace posture {
namespace {

constexpr const char* STYLE =
    "body{font:15px/1.45 system-ui,Helvetica,Arial,sans-serif;color:#222;max-width:1060px;"
    "margin:2em auto;padding:0 1em}"
    "h1{font-size:1.5em}h2{font-size:1.15em;margin-top:2em}"
    "table{border-collapse:collapse}th,td{padding:.25em .8em;border-bottom:1px solid #ddd;"
    "text-align:right}th:first-child,td:first-child{text-align:left}th{color:#555}"
    ".chosen{background:#e6f3ea;font-weight:600}"
    ".status{padding:.7em 1em;border-radius:6px;background:#e6f3ea}.undecided{background:#fbeedd}"
    ".bar{background:#0072b2;height:.8em;display:inline-block}"
    "td.wide{text-align:left;width:26em}"
    ".note{color:#555}";

std::string element(const std::string& tag, const std::string& content) {
  return "<" + tag + ">" + content + "</" + tag.substr(0, tag.find(' ')) + ">";
}

std::string row(const std::vector<std::string>& cells, const std::string& cell_tag = "td") {
  std::string content;
  for (const std::string& text : cells) content += element(cell_tag, escapedMarkup(text));
  return content;
}

std::string headline(const RegistrationResult& result) {
  const bool registered = result.status == Status::REGISTERED;
  return element(
      registered ? "p class=\"status\"" : "p class=\"status undecided\"",
      element("b", registered ? "Registered. " : "Undecided. ") + escapedMarkup(result.message));
}

std::string figures(const RegistrationResult& result) {
  const long accepted = mappedCount(result.correspondence.on_target), all = presentCount(result);
  std::vector<std::vector<std::string>> rows = {
      {result.source_scan ? "Source points with a counterpart"
                          : "Source vertices with a counterpart",
       std::to_string(accepted) + " of " + std::to_string(all)},
      {"A source length times this is a target length", formatShort(result.scale)}};
  if (!result.hypotheses.empty()) {
    rows.push_back({"Energy of the runner-up over that of the chosen candidate",
                    formatShort(runnerUpRatio(result))});
    rows.push_back({"Consistency threshold c0", formatShort(result.consistency_threshold)});
  } else {
    rows.push_back({"Trust, from 0 to 1", formatFixed(result.trust, 2)});
  }
  std::string content;
  for (const auto& cells : rows) content += element("tr", row(cells));
  return element("table", content);
}

std::string candidates(const RegistrationResult& result) {
  std::string content = element(
      "tr",
      row({"Axis signs", "E_H", "matched", "kernel", "accepted", "common", "E(M0)", "E(M1)", "E_D"},
          "th"));
  for (std::size_t k = 0; k < result.hypotheses.size(); ++k) {
    const HypothesisSummary& candidate = result.hypotheses[k];
    std::string signs;
    for (const int sign : candidate.axis_signs) signs += sign < 0 ? "-" : sign > 0 ? "+" : "0";
    const std::string cells = row({signs,
                                   formatShort(candidate.assignment_cost),
                                   std::to_string(candidate.matched_samples),
                                   std::to_string(candidate.kernel_samples),
                                   std::to_string(candidate.accepted_vertices),
                                   std::to_string(candidate.common_vertices),
                                   formatShort(candidate.source_energy),
                                   formatShort(candidate.target_energy),
                                   formatShort(candidate.energy)});
    const bool chosen = static_cast<int>(k) == result.chosen;
    content += element(chosen ? "tr class=\"chosen\"" : "tr", cells);
  }
  return element("table", content);
}

std::string alternatives(const RegistrationResult& result) {
  std::string content = element("tr",
                                row({"Distance from the chosen answer, % of sqrt(area)",
                                     "refined score",
                                     "score",
                                     "bending",
                                     "curvature",
                                     "distortion",
                                     "return miss",
                                     "let go",
                                     "orientation"},
                                    "th"));
  for (std::size_t k = 0; k < result.alternatives.size(); ++k) {
    const AlternativeSummary& a = result.alternatives[k];
    const std::string cells = row({formatFixed(100 * a.gap, 1),
                                   a.refined_score ? formatFixed(*a.refined_score, 2) : "-",
                                   formatFixed(a.score, 2),
                                   formatShort(a.bending),
                                   formatShort(a.curvature),
                                   formatShort(a.distortion),
                                   formatShort(a.return_miss),
                                   formatShort(a.let_go),
                                   formatFixed(a.orientation, 2)});
    const bool chosen = static_cast<int>(k) == result.chosen;
    content += element(chosen ? "tr class=\"chosen\"" : "tr", cells);
  }
  return element("table", content);
}

/// Rows that have a figure for each side.
class SidesTable {
 public:
  explicit SidesTable(const RunDescription& run)
      : content_(element("tr", row({"", "source: " + run.source, "target: " + run.target}, "th"))) {
  }

  void add(const std::string& name, const std::string& source, const std::string& target) {
    content_ += element("tr", row({name, source, target}));
  }
  void count(const std::string& name, int source, int target) {
    add(name, std::to_string(source), std::to_string(target));
  }
  void figure(const std::string& name, double source, double target) {
    add(name, formatShort(source), formatShort(target));
  }
  std::string text() const { return element("table", content_); }

 private:
  std::string content_;
};

/// How the surfaces of sides that came as points were made.
void addScans(const RegistrationResult& result, SidesTable& table) {
  const auto scanRow = [&](const std::string& name, int ReconstructionSummary::*member) {
    const auto cell = [&](const std::optional<ScanSurface>& scan) {
      return scan ? std::to_string(scan->summary.*member) : std::string("a mesh");
    };
    table.add(name, cell(result.source_scan), cell(result.target_scan));
  };
  scanRow("Points", &ReconstructionSummary::points);
  scanRow("Missing points", &ReconstructionSummary::missing);
  scanRow("Outliers", &ReconstructionSummary::outliers);
  const auto warnings = [](const std::optional<ScanSurface>& scan) {
    std::string text;
    if (scan)
      for (const std::string& warning : scan->summary.warnings)
        text += (text.empty() ? "" : "; ") + warning;
    return text;
  };
  table.add("Doubts about the surface laid through them",
            warnings(result.source_scan),
            warnings(result.target_scan));
}

std::string shapes(const RegistrationResult& result, const RunDescription& run) {
  const ShapeSummary& a = result.source;
  const ShapeSummary& b = result.target;
  SidesTable table(run);
  if (result.source_scan || result.target_scan) addScans(result, table);
  table.count("Vertices", a.vertices, b.vertices);
  table.count("Faces", a.faces, b.faces);
  table.count("Vertices at seams, joined with others nearby",
              a.denoising.seam_vertices,
              b.denoising.seam_vertices);
  table.count(
      "Vertices far from their neighbours, set back", a.denoising.spikes, b.denoising.spikes);
  table.count(
      "Rounds of smoothing noise away", a.denoising.smoothing_rounds, b.denoising.smoothing_rounds);
  table.count("Faces of a floor or a wall, left out", a.background_faces, b.background_faces);
  table.count(
      "Unreferenced vertices", a.cleaning.unreferenced_vertices, b.cleaning.unreferenced_vertices);
  table.count("Welded vertices", a.cleaning.welded_vertices, b.cleaning.welded_vertices);
  table.count("Degenerate faces", a.cleaning.degenerate_faces, b.cleaning.degenerate_faces);
  table.count("Repeated faces", a.cleaning.repeated_faces, b.cleaning.repeated_faces);
  table.count("Faces turned round", a.cleaning.flipped_faces, b.cleaning.flipped_faces);
  table.count("Non-manifold edges", a.cleaning.non_manifold_edges, b.cleaning.non_manifold_edges);
  table.count("Connected parts", a.cleaning.components, b.cleaning.components);
  table.count(
      "Vertices off the main surface", a.cleaning.loose_vertices, b.cleaning.loose_vertices);
  table.count("Vertices of the main surface", a.clean_vertices, b.clean_vertices);
  table.count("Boundary edges", a.boundary_edges, b.boundary_edges);
  table.count("Holes closed for the search", a.patched_holes, b.patched_holes);
  table.count("Pieces joined for the search", a.joined_pieces, b.joined_pieces);
  table.count("Contacts cut open", a.parted_contacts, b.parted_contacts);
  table.count("Vertices added for the search", a.added_vertices, b.added_vertices);
  table.figure("Area", a.area, b.area);
  if (std::max(a.left_out_share, b.left_out_share) > 0)
    table.figure(
        "Of the largest other part left out, over that", a.left_out_share, b.left_out_share);
  if (std::min(a.compared_share, b.compared_share) < 1)
    table.figure(
        "Share of it compared, as the other side is a piece", a.compared_share, b.compared_share);
  table.figure("Mean edge length", a.mean_edge_length, b.mean_edge_length);
  table.count("Samples", a.samples, b.samples);
  table.figure("Stress of the canonical form", a.stress, b.stress);
  return table.text();
}

std::string list(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string content;
  for (const auto& [name, value] : entries) content += element("tr", row({name, value}));
  return element("table", content);
}

std::string thisRun(const RegistrationResult& result, const RunDescription& run) {
  double longest = 0;
  for (const StageTiming& timing : result.timings) longest = std::max(longest, timing.seconds);
  std::string content;
  for (const StageTiming& timing : result.timings) {
    const double width = longest > 0 ? 100 * timing.seconds / longest : 0;
    content += element(
        "tr",
        row({stageTitle(timing.attempt, timing.stage), formatFixed(timing.seconds, 2) + " s"}) +
            element("td class=\"wide\"",
                    "<span class=\"bar\" style=\"width:" + formatFixed(width, 1) + "%\"></span>"));
  }
  const std::string memory = formatFixed(peakMemoryMib(), 0) + " MiB";
  return element("table", content) +
         element("p",
                 "In all " + formatFixed(run.seconds, 2) + " s with " +
                     std::to_string(run.threads) + (run.threads == 1 ? " thread" : " threads") +
                     ", at most " + memory + " of memory.");
}

}  // namespace

std::string reportHtml(const RegistrationResult& result, const RunDescription& run) {
  const auto section = [](const std::string& title, const std::string& content) {
    return element("h2", title) + "\n" + content + "\n";
  };
  std::string body = element("h1", escapedMarkup(run.source + " \u2192 " + run.target)) + "\n" +
                     headline(result) + "\n" + figures(result) + "\n";
  if (!result.hypotheses.empty())
    body += section("Candidates",
                    element("p class=\"note\"",
                            "Each way to lay one canonical form on the other; the least deformed "
                            "common mesh (E_D) wins.") +
                        candidates(result));
  if (!result.alternatives.empty())
    body += section(
        "Answers compared",
        element("p class=\"note\"",
                "The different ways to lay one body on the other that keep the outside "
                "out. The score is ln bending + ln curvature + ln distortion + ln (0.02 "
                "+ return miss) - 4 ln (1 - let go); that of those refined with what they "
                "pay for hands and feet on the mirror images of their like, and by how much "
                "worse ends of limbs fit than under the best of them. The one with the "
                "lowest refined score wins.") +
            alternatives(result));
  body += section("Shapes", shapes(result, run));
  if (!run.options.empty()) body += section("Options", list(run.options));
  if (!run.files.empty()) body += section("Files", list(run.files));
  body += section("This run", thisRun(result, run));
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
         escapedMarkup(run.source + " - " + run.target) + "</title><style>" + STYLE +
         "</style></head>\n<body>\n" + body + "</body></html>\n";
}

}  // namespace posture
