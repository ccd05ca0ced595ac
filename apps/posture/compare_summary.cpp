// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/map_error.h>
#include <posture/evaluation/statistics.h>
#include <posture/report/table.h>

#include "compare_report.h"
#include "compare_run.h"
#include "compare_variation.h"
#include "error_json.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace posture::app {
namespace {

using Cells = std::vector<std::string>;
using Runs = std::vector<Json>;

constexpr std::size_t LONGEST_LIST = 10;  // of pairs in a sentence; comparison.csv has all

bool isKnown(double figure) { return std::isfinite(figure); }

double errorOf(const Json& run) { return numberAt(run, "/errors/mean_x100"); }

/// The figure that methods are ranked by.
double errorWithMisses(const Json& run) {
  if (missedAll(run)) return 100 * curvePlaces().back();
  return numberAt(run, "/errors/mean_with_misses_x100");
}

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
  return select(runs, [&](const Json& run) { return textAt(run, key) == value; });
}

/// The different values, in the order of the runs.
std::vector<std::string> valuesOf(const Runs& runs, const char* key) {
  std::vector<std::string> values;
  for (const Json& run : runs)
    if (std::find(values.begin(), values.end(), textAt(run, key)) == values.end())
      values.push_back(textAt(run, key));
  return values;
}

int countOf(const Runs& runs, const std::vector<std::string>& statuses) {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), [&](const Json& run) {
    return std::find(statuses.begin(), statuses.end(), textAt(run, "status")) != statuses.end();
  }));
}

/// The largest change of a pair's error against that of the aligned source.
std::string changeCell(const Runs& of_method, const Runs& runs) {
  if (textAt(runs.front(), "variation") == "aligned") return "-";
  std::map<std::string, double> aligned;
  for (const Json& run : where(of_method, "variation", "aligned"))
    aligned.emplace(textAt(run, "id"), errorOf(run));
  double largest_change = std::nan("");
  for (const Json& run : runs) {
    const auto found = aligned.find(textAt(run, "id"));
    if (found == aligned.end() || !isKnown(found->second)) continue;
    const double before = found->second, after = errorOf(run);
    if (!isKnown(after)) return "failed";
    const double change = after == before ? 0 : std::abs(after / before - 1);
    if (!(largest_change >= change)) largest_change = change;
  }
  return std::isinf(largest_change) ? "inf" : formatPercent(largest_change);
}

/// Of the true pairs, or of the source's points where no truth is known.
double shareMapped(const Json& run) {
  if (missedAll(run)) return 0;
  if (run.contains("errors"))
    return numberAt(run, "/errors/mapped_pairs") / numberAt(run, "/errors/true_pairs");
  return numberAt(run, "/mapped") / numberAt(run, "/source_vertices");
}

double averageOf(const Runs& runs, const std::function<double(const Json&)>& figure) {
  std::vector<double> known;
  for (const Json& run : runs)
    if (const double value = figure(run); isKnown(value)) known.push_back(value);
  return mean(known);
}

std::string shareBelow(const Json& run, double place) {
  if (!run.contains("errors")) return "-";
  return formatPercent(curveAt(run["errors"], place));
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
  return {textAt(chosen.front(), "variation"), nameOfMethod(textAt(chosen.front(), "method"))};
}

TextTable pairTable(const Runs& runs) {
  TextTable table{{"source",
                   "method",
                   "status",
                   "error",
                   "mapped",
                   "with misses",
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
               {textAt(run, "status"),
                shown(errorOf(run)),
                formatPercent(shareMapped(run)),
                shown(errorWithMisses(run)),
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
  for (const char* name :
       {"all", "mapped", "with misses", "change", "converged", "came to nothing", "s", "MiB"})
    table.header.emplace_back(name);
  forEachRow(runs, [&](const Runs& chosen, const Runs& of_method) {
    Cells row = rowHead(chosen);
    for (const std::string& family : families)
      row.push_back(shown(mean(figures(where(chosen, "family", family), "/errors/mean_x100"))));
    const bool can_converge = textAt(chosen.front(), "method") != "as-given";
    row.insert(row.end(),
               {shown(mean(figures(chosen, "/errors/mean_x100"))),
                formatPercent(averageOf(chosen, shareMapped)),
                shown(averageOf(chosen, errorWithMisses)),
                changeCell(of_method, chosen),
                can_converge ? std::to_string(countOf(chosen, {"converged", "registered"})) +
                                   " of " + std::to_string(chosen.size())
                             : "-",
                std::to_string(countOf(chosen, {"failed", "refused", "not run"})),
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
               {formatPercent(average("/mean_distance"), 2),
                formatPercent(average("/stretch")),
                formatPercent(average("/source_near")),
                formatPercent(average("/target_near"))});
    table.rows.push_back(row);
  });
  return table;
}

/// Methods of a pair whose figures are the same as shown.
struct Place {
  std::string figure;
  Cells methods;  // names

  bool has(const std::string& key) const {
    return std::find(methods.begin(), methods.end(), nameOfMethod(key)) != methods.end();
  }
};

/// The least figure first, without the runs that have none.
std::vector<Place> places(const Runs& of_pair,
                          const std::function<double(const Json&)>& figure,
                          const std::function<std::string(double)>& show) {
  Runs known = select(of_pair, [&](const Json& run) { return isKnown(figure(run)); });
  std::stable_sort(known.begin(), known.end(), [&](const Json& a, const Json& b) {
    return figure(a) < figure(b);
  });
  std::vector<Place> order;
  for (const Json& run : known) {
    if (order.empty() || order.back().figure != show(figure(run)))
      order.push_back({show(figure(run)), {}});
    order.back().methods.push_back(nameOfMethod(textAt(run, "method")));
  }
  return order;
}

/// By the error with misses, of the runs that have an answer.
std::vector<Place> placesByError(const Runs& of_pair) {
  const Runs answered = select(of_pair, [](const Json& run) { return run.contains("errors"); });
  return places(answered, errorWithMisses, shown);
}

/// "ICP", "ICP and GICP", "ICP, GICP and NDT".
std::string listed(const Cells& names) {
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i)
    words += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return words;
}

std::string methodsAre(const Cells& names) {
  return (names.size() == 1 ? "method is " : "methods are ") + listed(names);
}

/// "posture failed"; empty: it has an answer, or there is no run of it.
std::string lackOfOurs(const Runs& of_pair) {
  for (const Json& run : where(of_pair, "method", "posture"))
    if (!run.contains("errors")) return "posture " + textAt(run, "status");
  return "";
}

std::string bestByError(const Runs& of_pair, const std::vector<Place>& order) {
  const Place& best = order.front();
  std::string sentence = best.has("as-given")
                             ? "no method improves on the source as given, error with misses "
                             : "the best " + methodsAre(best.methods) + ", error with misses ";
  sentence += best.figure;
  for (std::size_t place = 1; place < order.size(); ++place)
    if (place == 1 || order[place].has("posture"))
      sentence += (place == 1 ? "; next " : "; ") + listed(order[place].methods) + ", " +
                  order[place].figure;
  if (const std::string lack = lackOfOurs(of_pair); !lack.empty()) sentence += "; " + lack;
  return sentence + ".";
}

std::string bestOfPair(const Runs& of_pair) {
  const std::vector<Place> order = placesByError(of_pair);
  if (!order.empty()) return bestByError(of_pair, order);
  const std::vector<Place> near = places(
      of_pair,
      [](const Json& run) { return numberAt(run, "/mean_distance"); },
      [](double distance) { return formatPercent(distance, 2); });
  if (near.empty()) return "no method has a result.";
  return "no truth is known; nearest to the target is " + listed(near.front().methods) +
         ", on average " + near.front().figure + " of its size.";
}

/// "posture on 60, ICP and GICP on 2", the most first.
std::string winners(const std::map<std::string, int>& wins) {
  std::vector<std::pair<std::string, int>> order(wins.begin(), wins.end());
  std::stable_sort(
      order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string words;
  for (const auto& [methods, count] : order)
    words += (words.empty() ? "" : ", ") + methods + " on " + std::to_string(count);
  return words;
}

/// "cat-ref-01 (ICP 3.2, posture 4.1)"; empty where posture is best or was not run.
std::string whereBetter(const std::string& id,
                        const Runs& of_pair,
                        const std::vector<Place>& order) {
  const Place& best = order.front();
  if (best.has("posture")) return "";
  std::string ours = lackOfOurs(of_pair);
  for (const Place& place : order)
    if (place.has("posture")) ours = "posture " + place.figure;
  if (ours.empty()) return "";
  return id + " (" + listed(best.methods) + " " + best.figure + ", " + ours + ")";
}

std::string bestOfList(const Runs& of_variation) {
  std::map<std::string, int> wins;
  Cells better;
  int judged = 0;
  for (const std::string& id : valuesOf(of_variation, "id")) {
    const Runs of_pair = where(of_variation, "id", id);
    const std::vector<Place> order = placesByError(of_pair);
    if (order.empty()) continue;
    ++judged;
    ++wins[listed(order.front().methods)];
    const std::string other = whereBetter(id, of_pair, order);
    if (!other.empty()) better.push_back(other);
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
