// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "result_files.h"

#include <posture/core/error.h>
#include <posture/io/atomic_file.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>
#include <posture/report/colors.h>

#include "folder.h"
#include <algorithm>
#include <locale>
#include <set>
#include <system_error>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

/// Both verbs write it.
constexpr const char* SEGMENTS = "segments.ply";

std::string alternativeName(std::size_t k) { return "alternative-" + std::to_string(k); }

/// Whether it is `before`, a number and one of `ends`.
bool isNumbered(const std::string& name,
                const std::string& before,
                const std::vector<std::string>& ends) {
  if (name.rfind(before, 0) != 0) return false;
  const std::size_t end = name.find_first_not_of("0123456789", before.size());
  return end != std::string::npos && end > before.size() &&
         std::find(ends.begin(), ends.end(), name.substr(end)) != ends.end();
}

bool isSegmentFile(const std::string& name) {
  return name == SEGMENTS || name == "segments.csv" || name == "segments.json" ||
         isNumbered(name, "pose-", {"_segments.ply"});
}

bool isResultFile(const std::string& name) {
  static const std::set<std::string> NAMES{"correspondence.csv",
                                           "correspondence_back.csv",
                                           "registered.ply",
                                           "registered_surface.ply",
                                           "report.html",
                                           "report.json",
                                           "source_colored.ply",
                                           "source_surface.csv",
                                           "source_surface.ply",
                                           "target_colored.ply",
                                           "target_surface.csv",
                                           "target_surface.ply"};
  return NAMES.count(name) > 0 || isSegmentFile(name) ||
         isNumbered(name, "alternative-", {".csv", "_target_colored.ply"});
}

using IsName = bool (*)(const std::string&);

std::vector<fs::path> namesIn(const fs::path& folder, IsName is_one) {
  std::vector<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (is_one(entry.path().filename().string())) names.push_back(entry.path().filename());
  return names;
}

/// A link is as good as the file.
void requireApart(const fs::path& folder, const std::vector<fs::path>& inputs, IsName is_one) {
  std::error_code error;
  for (const fs::path& name : namesIn(folder, is_one)) {
    if (fs::is_directory(folder / name, error))
      throw InputError((folder / name).string() + ": is a folder, where a result is to be");
    for (const fs::path& input : inputs)
      if (fs::equivalent(folder / name, input, error))
        throw InputError(input.string() + ": would be written over, as the results go to " +
                         folder.string());
  }
}

}  // namespace

void writeColored(const fs::path& path,
                  const Points& points,
                  const Faces& faces,
                  const Colors& colors) {
  if (faces.rows() > 0) {
    writeMesh(path, {points, faces}, colors);
    return;
  }
  PointCloud cloud;
  cloud.points = points;
  cloud.colors = colors;
  writePointCloud(path, cloud);
}

std::vector<std::pair<std::string, std::string>> resultFiles(const RegistrationResult& result,
                                                             bool with_segments) {
  std::vector<std::pair<std::string, std::string>> files = {
      {"correspondence.csv", "for each source vertex (point) its place on the target"},
      {"registered.ply", "the source, moved onto the target"},
      {"source_colored.ply", "the source, one colour a place; grey: no counterpart"},
      {"target_colored.ply", "the target, in the colours of its counterparts"}};
  if (with_segments)
    files.emplace_back("segments.ply", "the source, one colour for what moves almost rigidly");
  if (result.back)
    files.emplace_back("correspondence_back.csv",
                       "for each target vertex (point) its place on the source");
  for (const auto& [side, scan] :
       {std::pair("source", &result.source_scan), std::pair("target", &result.target_scan)}) {
    if (!*scan) continue;
    files.emplace_back(side + std::string("_surface.ply"),
                       "the surface laid through the points of the " + std::string(side));
    files.emplace_back(side + std::string("_surface.csv"), "for each point its place on it");
  }
  if (result.source_scan)
    files.emplace_back("registered_surface.ply", "source_surface.ply, moved onto the target");
  if (result.source_denoised.rows() > 0)
    files.emplace_back("source_surface.ply", "the source as it was registered, denoised");
  for (std::size_t k = 0; k < result.alternatives.size(); ++k) {
    if (result.alternatives[k].correspondence.on_target.empty()) continue;
    files.emplace_back(alternativeName(k) + ".csv", "correspondence.csv of another answer");
    files.emplace_back(alternativeName(k) + "_target_colored.ply",
                       "target_colored.ply of that answer");
  }
  return files;
}

void requireNoResultFiles(const fs::path& folder, const std::vector<fs::path>& inputs) {
  requireApart(folder, inputs, isResultFile);
}

void requireNoSegmentFiles(const fs::path& folder, const std::vector<fs::path>& inputs) {
  requireApart(folder, inputs, isSegmentFile);
}

void requireNoPartOfResult(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  for (const fs::path& name : namesIn(folder, isResultFile))
    if (fs::equivalent(folder / name, file, error))
      throw InputError(file.string() + ": is part of the result in " + folder.string());
}

void removeResultFiles(const fs::path& folder) {
  removeFrom(folder, "report.json");  // first: without it the folder is no result
  for (const fs::path& name : namesIn(folder, isResultFile)) removeFrom(folder, name);
}

void removeSegmentFiles(const fs::path& folder) {
  const bool of_register = fs::exists(folder / "report.json");
  removeFrom(folder, "segments.json");  // first: without it the folder is no result
  for (const fs::path& name : namesIn(folder, isSegmentFile))
    if (name != SEGMENTS || !of_register) removeFrom(folder, name);
}

void writeSurfaceLink(const fs::path& path, const ScanSurface& surface) {
  AtomicFile file(path);
  std::ostream& out = file.stream();
  out.imbue(std::locale::classic());
  out.precision(9);
  out << "point,vertex,face,b0,b1,b2,offset\n";
  for (std::size_t i = 0; i < surface.on_mesh.size(); ++i) {
    const SurfacePoint& at = surface.on_mesh[i];
    out << i << ',' << at.vertex << ',' << at.face << ',' << at.barycentric[0] << ','
        << at.barycentric[1] << ',' << at.barycentric[2] << ','
        << surface.offset[static_cast<Eigen::Index>(i)] << '\n';
  }
  file.commit();
}

Colors writeSegments(const fs::path& path, const Shape& shape, const ShapeSegments& segments) {
  Colors colors = partColors(
      segments.label,
      partPalette(segments.parts.count, segments.parts.label, segments.surface.mesh.faces));
  writeColored(path, shape.cloud.points, shape.faces, colors);
  return colors;
}

void writeResultFiles(const fs::path& folder,
                      const Shape& source,
                      const Shape& target,
                      const RegistrationResult& result,
                      const std::optional<ShapeSegments>& segments) {
  const Colors colors = placeColors(source.cloud.points);
  const auto writeTarget = [&](const std::string& name, const Correspondence& map) {
    writeColored(folder / name,
                 target.cloud.points,
                 target.faces,
                 transferColors(colors, map, target, result.target_scan));
  };
  writeCorrespondence(folder / "correspondence.csv", result.correspondence);
  if (segments) writeSegments(folder / "segments.ply", source, *segments);
  if (result.back)
    writeCorrespondence(folder / "correspondence_back.csv", result.back->correspondence);
  writeColored(folder / "registered.ply", result.deformed, source.faces, colors);
  writeColored(folder / "source_colored.ply",
               source.cloud.points,
               source.faces,
               greyWhereRejected(colors, result.correspondence));
  writeTarget("target_colored.ply", result.correspondence);
  for (const auto& [side, scan] :
       {std::pair("source", &result.source_scan), std::pair("target", &result.target_scan)}) {
    if (!*scan) continue;
    writeMesh(folder / (side + std::string("_surface.ply")), (*scan)->mesh);
    writeSurfaceLink(folder / (side + std::string("_surface.csv")), **scan);
  }
  if (result.source_scan)
    writeMesh(folder / "registered_surface.ply",
              {result.surface_deformed, result.source_scan->mesh.faces});
  if (result.source_denoised.rows() > 0)
    writeMesh(folder / "source_surface.ply", {result.source_denoised, source.faces});
  for (std::size_t k = 0; k < result.alternatives.size(); ++k) {
    const Correspondence& other = result.alternatives[k].correspondence;
    if (other.on_target.empty()) continue;
    writeCorrespondence(folder / (alternativeName(k) + ".csv"), other);
    writeTarget(alternativeName(k) + "_target_colored.ply", other);
  }
}

}  // namespace posture::app
