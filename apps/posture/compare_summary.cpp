// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/statistics.h>

#include "compare_report.h"
#include "compare_run.h"
#include "compare_variation.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace posture::app {
namespace {

using Cells = std::vector<std::string>;
using Runs = std::vector<Json>;

constexpr std::size_t LONGEST_LIST = 10;  // of pairs in a sentence; comparison.csv has all

std::string text(const Json& json, const char* key) { return json.value(key, ""); }

double errorOf(const Json& run) { return numberAt(run, "/errors/mean_x100"); }

bool isKnown(double figure) { return std::isfinite(figure); }

std::string shown(double error) { return formatFixed(error, 2); }

std::string nameOfMethod(const std::string& key) {
  for (const ComparedMethod& method : comparedMethods())
    if (method.key == key) return method.name;
  return key;
}

Runs select(const Runs& runs, const std::function<bool(const Json&)>& has) {
  Runs selected;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(selected), has);
  return selected;
}

Runs where(const Runs& runs, const char* key, const std::string& value) {
  return select(runs, [&](const Json& run) { return text(run, key) == value; });
}

/// The different values, in the order of the runs.
std::vector<std::string> valuesOf(const Runs& runs, const char* key) {
  std::vector<std::string> values;
  for (const Json& run : runs)
    if (std::find(values.begin(), values.end(), text(run, key)) == values.end())
      values.push_back(text(run, key));
  return values;
}

int countOf(const Runs& runs, const std::vector<std::string>& statuses) {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), [&](const Json& run) {
    return std::find(statuses.begin(), statuses.end(), text(run, "status")) != statuses.end();
  }));
}

/// The largest change of a pair's error against that of the aligned source.
double largestChange(const Runs& of_method, const Runs& of_variation) {
  double change = std::nan("");
  for (const Json& run : of_variation)
    for (const Json& aligned : where(of_method, "variation", "aligned"))
      if (text(aligned, "id") == text(run, "id")) {
        const double there = std::abs(errorOf(run) / errorOf(aligned) - 1);
        if (isKnown(there) && !(change >= there)) change = there;
      }
  return change;
}

std::string changeCell(const Runs& of_method, const Runs& runs) {
  if (text(runs.front(), "variation") == "aligned") return "-";
  return percent(largestChange(of_method, runs));
}

std::string shareBelow(const Json& run, double place) {
  if (!run.contains("errors")) return "-";
  const std::vector<double> places = curvePlaces();
  const auto found = std::lower_bound(places.begin(), places.end(), place - 1e-9);
  return percent(run["errors"]["curve"][found - places.begin()].get<double>());
}

std::string side(const Json& run) {
  if (!run.contains("mirror")) return "-";
  return run["mirror"]["wrong_side"] == true ? "wrong" : "right";
}

/// Calls `row` with the runs of each method and variation, and with those of the method in all
/// variations.
void forEachRow(const Runs& runs, const std::function<void(const Runs&, const Runs&)>& row) {
  for (const std::string& variation : variations())
    for (const ComparedMethod& method : comparedMethods()) {
      const Runs of_method = where(runs, "method", method.key);
      const Runs chosen = where(of_method, "variation", variation);
      if (!chosen.empty()) row(chosen, of_method);
    }
}

Cells rowHead(const Runs& chosen) {
  return {text(chosen.front(), "variation"), nameOfMethod(text(chosen.front(), "method"))};
}

TextTable pairTable(const Runs& runs) {
  TextTable table{{"source",
                   "method",
                   "status",
                   "error",
                   "median",
                   "below 1 %",
                   "below 5 %",
                   "below 10 %",
                   "change",
                   "side",
                   "s",
                   "MiB"},
                  {}};
  forEachRow(runs, [&](const Runs& chosen, const Runs& of_method) {
    const Json& run = chosen.front();
    Cells row = rowHead(chosen);
    row.insert(row.end(),
               {text(run, "status"),
                shown(errorOf(run)),
                shown(numberAt(run, "/errors/median_x100")),
                shareBelow(run, 0.01),
                shareBelow(run, 0.05),
                shareBelow(run, 0.1),
                changeCell(of_method, chosen),
                side(run),
                formatFixed(numberAt(run, "/seconds"), 1),
                formatFixed(numberAt(run, "/peak_memory_mib"), 0)});
    table.rows.push_back(row);
  });
  return table;
}

/// One column a family that has a truth.
TextTable listTable(const Runs& runs) {
  const Runs judged = select(runs, [](const Json& run) { return isKnown(errorOf(run)); });
  const std::vector<std::string> families = valuesOf(judged, "family");
  TextTable table{{"source", "method"}, {}};
  for (const std::string& family : families) table.header.push_back(family.empty() ? "-" : family);
  for (const char* name : {"all", "change", "converged", "came to nothing", "s", "MiB"})
    table.header.emplace_back(name);
  forEachRow(runs, [&](const Runs& chosen, const Runs& of_method) {
    Cells row = rowHead(chosen);
    for (const std::string& family : families)
      row.push_back(shown(mean(figures(where(chosen, "family", family), "/errors/mean_x100"))));
    const bool can_converge = text(chosen.front(), "method") != "as-given";
    row.insert(row.end(),
               {shown(mean(figures(chosen, "/errors/mean_x100"))),
                changeCell(of_method, chosen),
                can_converge ? std::to_string(countOf(chosen, {"converged", "registered"})) +
                                   " of " + std::to_string(chosen.size())
                             : "-",
                std::to_string(countOf(chosen, {"failed", "not run"})),
                formatFixed(percentile(figures(chosen, "/seconds"), 0.5), 1),
                formatFixed(largest(figures(chosen, "/peak_memory_mib")), 0)});
    table.rows.push_back(row);
  });
  return table;
}

TextTable fitTable(const Runs& runs) {
  TextTable table{{"source", "method", "distance", "stretch", "source near", "target near"}, {}};
  forEachRow(runs, [&](const Runs& chosen, const Runs&) {
    const auto average = [&](const char* pointer) { return mean(figures(chosen, pointer)); };
    Cells row = rowHead(chosen);
    row.insert(row.end(),
               {percent(average("/mean_distance"), 2),
                percent(average("/stretch")),
                percent(average("/source_near")),
                percent(average("/target_near"))});
    table.rows.push_back(row);
  });
  return table;
}

/// The runs of a pair whose figure is known, the least first; ties keep their order.
Runs ranked(const Runs& of_pair, const std::function<double(const Json&)>& figure) {
  Runs known = select(of_pair, [&](const Json& run) { return isKnown(figure(run)); });
  std::stable_sort(known.begin(), known.end(), [&](const Json& a, const Json& b) {
    return figure(a) < figure(b);
  });
  return known;
}

std::string bestOfPair(const Runs& of_pair) {
  const Runs best = ranked(of_pair, errorOf);
  if (!best.empty()) {
    const auto named = [](const Json& run) { return nameOfMethod(text(run, "method")); };
    std::string sentence = "the best method is " + named(best.front()) + ", mean error " +
                           shown(errorOf(best.front()));
    if (text(best.front(), "method") == "as-given")
      sentence =
          "no method improves on the source as given, mean error " + shown(errorOf(best.front()));
    for (std::size_t place = 1; place < best.size(); ++place)
      if (place == 1 || text(best[place], "method") == "posture")
        sentence += (place == 1 ? "; next " : "; ") + named(best[place]) + ", " +
                    shown(errorOf(best[place]));
    return sentence + ".";
  }
  const Runs near =
      ranked(of_pair, [](const Json& run) { return numberAt(run, "/mean_distance"); });
  if (near.empty()) return "no method has a result.";
  return "no truth is known; nearest to the target is " +
         nameOfMethod(text(near.front(), "method")) + ", on average " +
         percent(numberAt(near.front(), "/mean_distance"), 2) + " of its diagonal.";
}

/// "posture on 60 pairs, ICP on 2", the most first.
std::string winners(const std::map<std::string, int>& wins) {
  std::vector<std::pair<std::string, int>> order(wins.begin(), wins.end());
  std::stable_sort(
      order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string words;
  for (const auto& [method, count] : order)
    words += (words.empty() ? "" : ", ") + nameOfMethod(method) + " on " + std::to_string(count);
  return words;
}

std::string bestOfList(const Runs& of_variation) {
  std::map<std::string, int> wins;
  Cells better;
  int judged = 0;
  for (const std::string& id : valuesOf(of_variation, "id")) {
    const Runs best = ranked(where(of_variation, "id", id), errorOf);
    if (best.empty()) continue;
    ++judged;
    ++wins[text(best.front(), "method")];
    const Runs ours = where(best, "method", "posture");
    if (text(best.front(), "method") != "posture" && !ours.empty())
      better.push_back(id + " (" + nameOfMethod(text(best.front(), "method")) + " " +
                       shown(errorOf(best.front())) + ", posture " + shown(errorOf(ours.front())) +
                       ")");
  }
  if (judged == 0) return "no truth is known, so no method is the best one.";
  std::string sentence =
      "of " + std::to_string(judged) + " pairs with a truth, the best method is " + winners(wins);
  if (better.empty()) return sentence + ".";
  sentence += ". Another is better than posture on ";
  for (std::size_t i = 0; i < std::min(better.size(), LONGEST_LIST); ++i)
    sentence += (i > 0 ? ", " : "") + better[i];
  if (better.size() > LONGEST_LIST)
    sentence += " and " + std::to_string(better.size() - LONGEST_LIST) + " more";
  return sentence + ".";
}

}  // namespace

Comparison summarizeRuns(const std::vector<Json>& runs) {
  const bool single = valuesOf(runs, "id").size() == 1;
  Comparison comparison{single ? pairTable(runs) : listTable(runs), fitTable(runs), {}};
  for (const std::string& variation : variations()) {
    const Runs chosen = where(runs, "variation", variation);
    if (chosen.empty()) continue;
    comparison.verdicts.push_back("Source " + variation + ": " +
                                  (single ? bestOfPair(chosen) : bestOfList(chosen)));
  }
  return comparison;
}

}  // namespace posture::app
