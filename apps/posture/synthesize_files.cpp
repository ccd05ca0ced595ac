// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize_files.h"

#include <posture/io/atomic_file.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>

#include "folder.h"
#include "motion_json.h"
#include <cstdio>
#include <locale>
#include <sstream>
#include <utility>

namespace posture::app {
namespace {

namespace fs = std::filesystem;

std::string pairKind(const BodyOptions& body) {
  return body.noise > 0 ? "noise" : body.holes > 0 ? "holes" : "isometric";
}

/// What was asked for, in words without a comma.
std::string describe(const SynthesizedShape& source, const SynthesizedShape& target) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const BodyOptions &a = source.options, &b = target.options;
  text << "synthetic; tessellations " << a.tessellation << " and " << b.tessellation;
  if (a.holes > 0) text << "; " << a.holes << " holes of radius " << a.hole_radius << " each";
  if (a.noise > 0) text << "; noise " << a.noise;
  return text.str();
}

/// Where the points of a scan lie on its surface: rows `point vertex`.
std::vector<VertexPair> surfaceVertices(const SimulatedScan& scan) {
  std::vector<VertexPair> pairs;
  for (std::size_t i = 0; i < scan.vertex.size(); ++i)
    if (scan.vertex[i] >= 0) pairs.push_back({static_cast<int>(i), scan.vertex[i]});
  return pairs;
}

}  // namespace

PairList::PairList(std::filesystem::path folder, bool scans)
    : folder_(std::move(folder)), scans_(scans) {
  removeFrom(folder_, "pairs.csv");
}

Json PairList::add(const std::string& family,
                   const SynthesizedShape& source,
                   const SynthesizedShape& target) {
  const std::string id = source.name + "-pose" + std::to_string(target.options.pose);
  return add({id, family, pairKind(source.options), source.meshFile(), target.meshFile()},
             groundTruth(source.body, target.body),
             mirrorTruth(source.body, target.body),
             describe(source, target));
}

Json PairList::addRigid(const std::string& family,
                        const SynthesizedShape& source,
                        const SynthesizedShape& target) {
  return add({family + "-rigid", family, "rigid", source.meshFile(), target.meshFile()},
             groundTruth(source.body, target.body),
             mirrorTruth(source.body, target.body),
             describe(source, target) + "; moved as a whole");
}

Json PairList::addScans(const std::string& family,
                        const SynthesizedShape& source,
                        const SynthesizedShape& target) {
  const std::string id = source.name + "-pose" + std::to_string(target.options.pose) + "-scan";
  return add({id, family, "scan", source.scanFile(), target.scanFile()},
             groundTruth(*source.scan, *target.scan),
             mirrorTruth(*source.scan, *target.scan),
             describe(source, target),
             {target.meshFile(), target.scanSurfaceFile()});
}

void PairList::write() const {
  const std::string more = scans_ ? ",target_surface,target_surface_vertices" : "";
  writeFile(folder_ / "pairs.csv",
            "id,family,kind,source,target,truth,mirror_truth,note" + more + "\n" + rows_);
}

Json PairList::add(const std::vector<std::string>& fields,
                   const std::vector<VertexPair>& truth,
                   const std::vector<VertexPair>& mirror_truth,
                   const std::string& note,
                   const Surface& surface) {
  const std::string& id = fields.front();
  const std::string file = id + ".txt", mirror_file = id + "-mirror.txt";
  writeVertexPairs(folder_ / file, truth);
  writeVertexPairs(folder_ / mirror_file, mirror_truth);
  for (const std::string& field : fields) rows_ += field + ",";
  rows_ += file + "," + mirror_file + "," + note;
  if (scans_) rows_ += "," + surface.mesh + "," + surface.vertices;
  rows_ += "\n";
  return {{"id", id}, {"truth", file}, {"mirror_truth", mirror_file}, {"true_pairs", truth.size()}};
}

void removeOtherFilesOf(const fs::path& folder, const SynthesizedShape& shape) {
  const auto others = shape.scan ? std::vector{shape.bonesFile()}
                                 : std::vector{shape.scanFile(), shape.scanSurfaceFile()};
  for (const std::string& file : others) removeFrom(folder, file);
}

Json writeShape(const fs::path& folder, const SynthesizedShape& shape, bool quiet) {
  const std::string file = shape.meshFile();
  const TriangleMesh& mesh = shape.scan ? shape.scan->surface : shape.body.mesh;
  const auto vertices = static_cast<long>(mesh.vertices.rows());
  const auto faces = static_cast<long>(mesh.faces.rows());
  writeMesh(folder / file, mesh);
  if (!quiet) std::fprintf(stderr, "%s: %ld vertices, %ld faces\n", file.c_str(), vertices, faces);
  Json json{{"file", file}, {"vertices", vertices}, {"faces", faces}};
  if (!shape.scan) return json;
  writePointCloud(folder / shape.scanFile(), shape.scan->cloud);
  writeVertexPairs(folder / shape.scanSurfaceFile(), surfaceVertices(*shape.scan));
  const auto points =
      static_cast<long>(shape.scan->cloud.points.rowwise().sum().array().isFinite().count());
  if (!quiet) std::fprintf(stderr, "%s: %ld points\n", shape.scanFile().c_str(), points);
  json["scan"] = {{"file", shape.scanFile()},
                  {"points", points},
                  {"surface_vertices", shape.scanSurfaceFile()}};
  return json;
}

void writeBones(const fs::path& path, const ArticulatedBody& body) {
  AtomicFile file(path);
  file.stream().imbue(std::locale::classic());
  file.stream() << "vertex,bone,weight\n";
  for (std::size_t v = 0; v < body.bone.size(); ++v)
    file.stream() << v << ',' << body.bone_names[body.bone[v]] << ','
                  << body.bone_weight[static_cast<Eigen::Index>(v)] << '\n';
  file.commit();
}

Json describeBones(const ArticulatedBody& body) {
  Json bones = Json::array();
  for (std::size_t b = 0; b < body.bone_names.size(); ++b) {
    Json bone{{"bone", body.bone_names[b]}};
    bone.update(toJson(body.bone_motion[b]));
    bones.push_back(std::move(bone));
  }
  return bones;
}

}  // namespace posture::app
