// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/peak_memory.h>
#include <posture/report/report_json.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace posture {
namespace {

using Json = nlohmann::ordered_json;

/// Infinity and NaN have no JSON.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json share(double part, double whole) { return number(part / whole); }

Json describe(const Denoising& denoising) {
  return {{"seam_vertices", denoising.seam_vertices},
          {"spikes", denoising.spikes},
          {"smoothing_rounds", denoising.smoothing_rounds}};
}

Json describe(const CleaningSummary& cleaning) {
  return {{"unreferenced_vertices", cleaning.unreferenced_vertices},
          {"welded_vertices", cleaning.welded_vertices},
          {"degenerate_faces", cleaning.degenerate_faces},
          {"repeated_faces", cleaning.repeated_faces},
          {"flipped_faces", cleaning.flipped_faces},
          {"non_manifold_edges", cleaning.non_manifold_edges},
          {"components", cleaning.components},
          {"loose_vertices", cleaning.loose_vertices}};
}

Json describe(const ReconstructionSummary& s) {
  return {{"points", s.points},
          {"missing", s.missing},
          {"repeated", s.repeated},
          {"outliers", s.outliers},
          {"dropped_pieces", s.dropped_pieces},
          {"through_points", s.through_points},
          {"spacing", number(s.spacing)},
          {"noise", number(s.noise)},
          {"mesh_spacing", number(s.mesh_spacing)},
          {"averaged", s.averaged},
          {"vertices", s.vertices},
          {"faces", s.faces},
          {"components", s.components},
          {"boundary_loops", s.boundary_loops},
          {"boundary_length", number(s.boundary_length)},
          {"thin_share", number(s.thin)},
          {"contacts", s.contacts},
          {"double_walls", s.double_walls},
          {"oriented_by_sensor", s.oriented_by_sensor},
          {"oriented_by_normals", s.oriented_by_normals},
          {"warnings", s.warnings}};
}

/// \param scan  what was found on the way from points to the mesh; null for a mesh.
Json describe(const std::string& file,
              const ShapeSummary& shape,
              const std::optional<ScanSurface>& scan) {
  return {{"file", file},
          {"scan", scan ? describe(scan->summary) : Json(nullptr)},
          {"vertices", shape.vertices},
          {"faces", shape.faces},
          {"denoising", describe(shape.denoising)},
          {"background_faces", shape.background_faces},
          {"cleaning", describe(shape.cleaning)},
          {"main_surface",
           {{"vertices", shape.clean_vertices},
            {"boundary_edges", shape.boundary_edges},
            {"patched_holes", shape.patched_holes},
            {"joined_pieces", shape.joined_pieces},
            {"parted_contacts", shape.parted_contacts},
            {"added_vertices", shape.added_vertices},
            {"area", number(shape.area)},
            {"left_out_share", number(shape.left_out_share)},
            {"compared_share", number(shape.compared_share)},
            {"mean_edge_length", number(shape.mean_edge_length)}}},
          {"samples", shape.samples},
          {"canonical_form_stress", number(shape.stress)}};
}

Json describe(const HypothesisSummary& hypothesis, bool chosen) {
  return {{"axis_signs", hypothesis.axis_signs},
          {"chosen", chosen},
          {"assignment_cost_E_H", number(hypothesis.assignment_cost)},
          {"matched_samples", hypothesis.matched_samples},
          {"mean_consistency", number(hypothesis.consistency)},
          {"kernel_samples", hypothesis.kernel_samples},
          {"accepted_vertices", hypothesis.accepted_vertices},
          {"common_vertices", hypothesis.common_vertices},
          {"source_energy_E_M0", number(hypothesis.source_energy)},
          {"target_energy_E_M1", number(hypothesis.target_energy)},
          {"energy_E_D", number(hypothesis.energy)}};
}

Json describe(const AlternativeSummary& alternative, bool chosen) {
  return {{"chosen", chosen},
          {"distance_from_chosen", number(alternative.gap)},
          {"score", number(alternative.score)},
          {"refined_score",
           alternative.refined_score ? number(*alternative.refined_score) : Json(nullptr)},
          {"bending", number(alternative.bending)},
          {"curvature_disagreement", number(alternative.curvature)},
          {"distance_distortion", number(alternative.distortion)},
          {"return_miss", number(alternative.return_miss)},
          {"let_go", number(alternative.let_go)},
          {"orientation_vote", number(alternative.orientation)}};
}

template <class Summary>
Json describeAll(const std::vector<Summary>& summaries, int chosen) {
  Json list = Json::array();
  for (std::size_t k = 0; k < summaries.size(); ++k)
    list.push_back(describe(summaries[k], static_cast<int>(k) == chosen));
  return list;
}

/// Whether the published method made it, which alone has hypotheses.
bool isPublished(const RegistrationResult& result) { return !result.hypotheses.empty(); }

/// The figures that tell how far to trust the result.
Json describeTrust(const RegistrationResult& result) {
  const long accepted = mappedCount(result.correspondence.on_target), all = presentCount(result);
  double confidence = 0;
  for (Eigen::Index i = 0; i < result.correspondence.confidence.size(); ++i)
    confidence += result.correspondence.confidence(i);
  Json trust = {{"source_vertices", all},
                {"accepted_vertices", accepted},
                {"accepted_share", number(mappedShare(result))},
                {"mean_confidence_of_accepted", share(confidence, double(accepted))}};
  if (isPublished(result)) trust["runner_up_energy_ratio"] = number(runnerUpRatio(result));
  if (!result.alternatives.empty()) {
    trust["trust"] = number(result.trust);
    trust["score"] = number(result.score);
    trust["hands"] = number(result.hands);
  }
  if (result.back)
    trust["there_and_back"] = {{"mean_miss", number(result.back->mean_miss)},
                               {"percentile_95_miss", number(result.back->percentile_95_miss)}};
  return trust;
}

Json versions() {
  const auto dotted = [](int a, int b, int c) {
    return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
  };
  return {
      {"posture", POSTURE_VERSION},
      {"eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"ceres", CERES_VERSION},
      {"pcl", PCL_VERSION_TEXT},
      {"nlohmann_json",
       dotted(
           NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"compiler", COMPILER_TEXT}};
}

Json pairs(const std::vector<std::pair<std::string, std::string>>& entries) {
  Json object = Json::object();
  for (const auto& [name, value] : entries) object[name] = value;
  return object;
}

Json describeRun(const RegistrationResult& result, const RunDescription& run) {
  Json stages = Json::array();
  for (const StageTiming& timing : result.timings)
    stages.push_back({{"attempt", timing.attempt},
                      {"stage", timing.stage},
                      {"seconds", number(timing.seconds)}});
  return {{"note", "differs from run to run; nothing else in this file does"},
          {"seconds", number(run.seconds)},
          {"stages", stages},
          {"peak_memory_bytes", peakMemoryBytes()},
          {"threads", run.threads}};
}

}  // namespace

std::string reconstructionJson(const ReconstructionSummary& summary) {
  return describe(summary).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

double runnerUpRatio(const RegistrationResult& result) {
  const double none = std::nan("");
  if (result.chosen < 0 || result.chosen >= static_cast<int>(result.hypotheses.size())) return none;
  const double best = result.hypotheses[result.chosen].energy;
  double second = none;
  for (std::size_t k = 0; k < result.hypotheses.size(); ++k)
    if (static_cast<int>(k) != result.chosen)
      second = std::fmin(second, result.hypotheses[k].energy);
  return second / best;
}

std::string reportJson(const RegistrationResult& result, const RunDescription& run) {
  Json report = {{"status", result.status == Status::REGISTERED ? "registered" : "undecided"},
                 {"message", result.message},
                 {"trust", describeTrust(result)},
                 {"source", describe(run.source, result.source, result.source_scan)},
                 {"target", describe(run.target, result.target, result.target_scan)},
                 {"scale_source_to_target", number(result.scale)},
                 {"chosen", result.chosen < 0 ? Json(nullptr) : Json(result.chosen)}};
  if (isPublished(result)) {
    report["consistency_threshold_c0"] = number(result.consistency_threshold);
    report["hypotheses"] = describeAll(result.hypotheses, result.chosen);
  } else {
    report["alternatives"] = describeAll(result.alternatives, result.chosen);
  }
  report["options"] = pairs(run.options);
  report["files"] = pairs(run.files);
  report["versions"] = versions();
  report["run"] = describeRun(result, run);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace posture
