// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Table of what reconstruct() makes of the benchmark's scans, of its meshes without their faces and
// of harder variants: geodesic distances on the reconstruction beside those on the whole shape.
//
//   reconstruction_table BENCHMARK [PART OF A CASE'S NAME]... [--all] [--write DIR]
//
// A row a case to stdout; --all: a row for PCL's methods too; --write: the surfaces as PLY files in
// DIR, which must exist.
#include <posture/core/rng.h>
#include <posture/core/seconds_since.h>
#include <posture/geodesic/fast_marching.h>
#include <posture/io/mesh_io.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/point_index.h>
#include <posture/scan/reconstruct.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace posture {
namespace {

struct Case {
  std::string name;
  std::function<PointCloud()> cloud;
  std::filesystem::path truth;
};

double diagonal(const Points& points) {
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

double percentile(std::vector<double> values, double p) {
  if (values.empty()) return 0;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(p * (static_cast<double>(values.size()) - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

struct GeodesicErrors {
  double median = 0, percentile_95 = 0, shortened = 0, lengthened = 0, unreachable = 0;  // per cent
  int unseen = 0;
};

/// 60 farthest-point samples of the whole shape where the scan has points; all pairs farther apart
/// than 8 % of its diagonal.
GeodesicErrors geodesicErrors(const TriangleMesh& truth,
                              const ScanSurface& surface,
                              const PointCloud& cloud) {
  constexpr int SAMPLES = 60;
  const double size = diagonal(truth.vertices);
  std::vector<int> rows;
  for (int i = 0; i < cloud.points.rows(); ++i)
    if (surface.on_mesh[i].vertex >= 0) rows.push_back(i);
  const PointIndex seen_index(cloud.points(rows, Eigen::all));
  const int n = static_cast<int>(truth.vertices.rows());
  std::vector<char> seen(n);
  for (int v = 0; v < n; ++v)
    seen[v] = seen_index.nearest(truth.vertices.row(v)).distance <
              std::max(2 * surface.summary.spacing, 0.005 * size);

  const FastMarching on_truth(truth);
  std::vector<double> covered(n, std::numeric_limits<double>::infinity());
  std::vector<int> samples{static_cast<int>(std::find(seen.begin(), seen.end(), 1) - seen.begin())};
  std::vector<std::vector<double>> true_distance;
  for (int s = 0; s < SAMPLES; ++s) {
    GeodesicField field;
    on_truth.march(samples.back(), field);
    true_distance.push_back(field.distance);
    int farthest = -1;
    for (int v = 0; v < n; ++v) {
      covered[v] = std::min(covered[v], field.distance[v]);
      if (seen[v] && std::isfinite(covered[v]) && (farthest < 0 || covered[v] > covered[farthest]))
        farthest = v;
    }
    if (s + 1 < SAMPLES) samples.push_back(farthest);
  }

  // Nearest vertex on the same side of the part.
  const Points true_normals = vertexNormals(truth), normals = vertexNormals(surface.mesh);
  const PointIndex mesh_index(surface.mesh.vertices);
  GeodesicErrors errors;
  std::vector<int> place(SAMPLES, -1);
  for (int s = 0; s < SAMPLES; ++s) {
    double nearest = 0.02 * size;
    for (int v = 0; v < surface.mesh.vertices.rows(); ++v) {
      const double distance =
          (surface.mesh.vertices.row(v) - truth.vertices.row(samples[s])).norm();
      if (distance < nearest && normals.row(v).dot(true_normals.row(samples[s])) > 0) {
        nearest = distance;
        place[s] = v;
      }
    }
    errors.unseen += place[s] < 0;
  }
  const FastMarching on_mesh(surface.mesh);
  std::vector<double> deviations;
  int pairs = 0, unreachable = 0, shortened = 0, lengthened = 0;
  for (int s = 0; s < SAMPLES; ++s) {
    if (place[s] < 0) continue;
    GeodesicField field;
    on_mesh.march(place[s], field);
    for (int t = s + 1; t < SAMPLES; ++t) {
      const double expected = true_distance[s][samples[t]];
      if (place[t] < 0 || !std::isfinite(expected) || expected < 0.08 * size) continue;
      ++pairs;
      const double ratio = field.distance[place[t]] / expected;
      if (!std::isfinite(ratio)) {
        ++unreachable;
        continue;
      }
      shortened += ratio < 0.9;
      lengthened += ratio > 1.1;
      deviations.push_back(std::abs(ratio - 1));
    }
  }
  errors.median = 100 * percentile(deviations, 0.5);
  errors.percentile_95 = 100 * percentile(deviations, 0.95);
  errors.shortened = 100.0 * shortened / pairs;
  errors.lengthened = 100.0 * lengthened / pairs;
  errors.unreachable = 100.0 * unreachable / pairs;
  return errors;
}

PointCloud verticesOf(const std::filesystem::path& path) {
  return {readMesh(path).mesh.vertices, {}, {}, 0, {}};
}

PointCloud withOutliers(PointCloud cloud, double share) {
  Rng rng(7);
  const Eigen::Index n = cloud.points.rows(), more = static_cast<Eigen::Index>(share * n);
  const Eigen::RowVector3d low = cloud.points.colwise().minCoeff(),
                           extent = cloud.points.colwise().maxCoeff() - low;
  cloud.points.conservativeResize(n + more, 3);
  for (Eigen::Index i = n; i < n + more; ++i)
    for (int k = 0; k < 3; ++k) cloud.points(i, k) = low[k] + extent[k] * rng.uniform();
  return cloud;
}

PointCloud withNoise(PointCloud cloud, double sigma) {
  Rng rng(8);
  for (int i = 0; i < cloud.points.size(); ++i) cloud.points.data()[i] += sigma * rng.normal();
  return cloud;
}

PointCloud quarter(const PointCloud& cloud) {
  Rng rng(9);
  std::vector<int> rows;
  for (int i = 0; i < cloud.points.rows(); ++i)
    if (rng.below(4) == 0) rows.push_back(i);
  return {cloud.points(rows, Eigen::all), {}, {}, 0, {}};
}

/// Points spread evenly over a mesh, with noise.
PointCloud sampled(const TriangleMesh& mesh, int count, double sigma) {
  Rng rng(10);
  const Vector areas = faceAreas(mesh);
  std::vector<double> sums(areas.size());
  double sum = 0;
  for (Eigen::Index f = 0; f < areas.size(); ++f) sums[f] = sum += areas[f];
  PointCloud cloud{Points(count, 3), {}, {}, 0, {}};
  for (int i = 0; i < count; ++i) {
    const auto f = std::min<std::ptrdiff_t>(
        std::lower_bound(sums.begin(), sums.end(), rng.uniform() * sum) - sums.begin(),
        areas.size() - 1);
    const double r = std::sqrt(rng.uniform()), t = rng.uniform();
    cloud.points.row(i) = (1 - r) * mesh.vertices.row(mesh.faces(f, 0)) +
                          r * (1 - t) * mesh.vertices.row(mesh.faces(f, 1)) +
                          r * t * mesh.vertices.row(mesh.faces(f, 2));
  }
  return withNoise(cloud, sigma);
}

std::vector<Case> allCases(const std::filesystem::path& benchmark) {
  const std::filesystem::path meshes = benchmark / "meshes";
  std::vector<Case> cases;
  for (const char* pair : {"cat0-cat3", "horse0-horse6", "michael0-michael4"})
    for (bool is_source : {true, false}) {
      const std::string both = pair, one = is_source ? both.substr(0, both.find('-'))
                                                     : both.substr(both.find('-') + 1);
      const std::filesystem::path scan =
          meshes / "scans" / ("scan-" + both + (is_source ? "-source.ply" : "-target.ply"));
      const std::filesystem::path truth = meshes / "large" / (one + ".ply");
      cases.push_back({"scan " + one, [=] { return verticesOf(scan); }, truth});
      if (one != "cat0" && one != "michael4" && one != "horse6") continue;
      for (double share : {0.02, 0.1})
        cases.push_back({"outliers-" + std::to_string(static_cast<int>(100 * share)) + "% " + one,
                         [=] { return withOutliers(verticesOf(scan), share); },
                         truth});
      // Noise of the scans is 0.0008 of the diagonal: so it is doubled, then threefold, fourfold.
      for (int times : {2, 3, 4})
        cases.push_back({"noise-" + std::to_string(times) + "x " + one,
                         [=] {
                           const double added = std::sqrt(times * times - 1.0) * 0.0008;
                           const PointCloud cloud = verticesOf(scan);
                           return withNoise(cloud, added * diagonal(readMesh(truth).mesh.vertices));
                         },
                         truth});
      cases.push_back({"quarter " + one, [=] { return quarter(verticesOf(scan)); }, truth});
    }
  for (const char* name : {"cat/cat-reference.obj",
                           "cat/cat-02.obj",
                           "horse/horse-reference.obj",
                           "horse/horse-03.obj",
                           "centaur/centaur0.off",
                           "centaur/centaur1.off",
                           "michael/michael0.off",
                           "victoria/victoria1.off",
                           "gorilla/gorilla1.off",
                           "faust/tr_reg_000.off",
                           "captures/cat-view-source.obj",
                           "captures/cat-view-target.obj",
                           "captures/color_mesh_0020.ply",
                           "captures/color_mesh_0050.ply",
                           "captures/color_mesh_0080.ply",
                           "captures/rabbit-scan.obj",
                           "captures/rabbit-template.obj",
                           "captures/walking-man-source.obj",
                           "captures/walking-man-target.obj"}) {
    const std::filesystem::path path = meshes / name;
    cases.push_back({"vertices " + path.stem().string(), [=] { return verticesOf(path); }, path});
  }
  for (double noise : {0.0, 0.0008, 0.002}) {
    const std::filesystem::path path = meshes / "large" / "michael0.ply";
    cases.push_back({"million-" + std::to_string(noise).substr(0, 6),
                     [=] {
                       const TriangleMesh mesh = readMesh(path).mesh;
                       return sampled(mesh, 1000000, noise * diagonal(mesh.vertices));
                     },
                     path});
  }
  return cases;
}

void printRow(const Case& one,
              const char* method,
              SurfaceMethod surface_method,
              const std::string& write_to) {
  const PointCloud cloud = one.cloud();
  const auto start = std::chrono::steady_clock::now();
  ScanSurface surface;
  try {
    surface = reconstruct(cloud, {surface_method});
  } catch (const std::exception& error) {
    std::printf("| %s | %s | %s |\n", one.name.c_str(), method, error.what());
    return;
  }
  const double seconds = secondsSince(start);
  const TriangleMesh truth = cleanMesh(readMesh(one.truth).mesh).mesh;
  const GeodesicErrors e = geodesicErrors(truth, surface, cloud);
  std::string check;
  try {
    check =
        HalfEdgeMesh(surface.mesh.faces, static_cast<int>(surface.mesh.vertices.rows())).check();
  } catch (const std::exception& error) {
    check = error.what();
  }
  const ReconstructionSummary& s = surface.summary;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf(
      "| %s | %s | %d | %d | %d | %d | %.2f | %.2f | %.1f | %.1f | %.1f | %.1f | %d | %.2f | %ld | "
      "%s |",
      one.name.c_str(),
      method,
      s.points,
      s.vertices,
      s.components,
      s.boundary_loops,
      s.boundary_length / diagonal(truth.vertices),
      e.median,
      e.percentile_95,
      e.shortened,
      e.lengthened,
      e.unreachable,
      e.unseen,
      seconds,
      usage.ru_maxrss / 1024,
      check.empty() ? "yes" : check.c_str());
  std::printf(" out %d avg %d noise/h %.2f dropped %d thin %.3f contacts %d %s\n",
              s.outliers,
              s.averaged,
              s.noise / s.spacing,
              s.dropped_pieces,
              s.thin,
              s.contacts,
              s.double_walls ? "double walls" : "");
  std::fflush(stdout);
  if (write_to.empty()) return;
  std::string file = one.name + "-" + method + ".ply";
  std::replace(file.begin(), file.end(), ' ', '-');
  writeMesh(std::filesystem::path(write_to) / file, surface.mesh);
}

}  // namespace
}  // namespace posture

int main(int argc, char** argv) {
  using posture::SurfaceMethod;
  if (argc < 2) {
    std::fprintf(
        stderr,
        "usage: reconstruction_table BENCHMARK [PART OF A NAME]... [--all] [--write DIR]\n");
    return 2;
  }
  bool all_methods = false;
  std::string write_to;
  std::vector<std::string> wanted;
  for (int i = 2; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--all")
      all_methods = true;
    else if (argument == "--write" && i + 1 < argc)
      write_to = argv[++i];
    else
      wanted.push_back(argument);
  }
  std::printf(
      "| case | method | points | vertices | pieces | loops | boundary / diagonal | median %% | "
      "95th %% | "
      "short %% | long %% | unreachable %% | unseen | s | MiB | manifold |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n");
  for (const auto& one : posture::allCases(argv[1])) {
    const auto named = [&](const std::string& part) {
      return one.name.find(part) != std::string::npos;
    };
    if (!wanted.empty() && std::none_of(wanted.begin(), wanted.end(), named)) continue;
    printRow(one, "own", SurfaceMethod::TANGENT_DELAUNAY, write_to);
    if (!all_methods) continue;
    printRow(one, "MLS", SurfaceMethod::MLS, write_to);
    printRow(one, "Poisson", SurfaceMethod::POISSON, write_to);
    printRow(one, "greedy", SurfaceMethod::GREEDY, write_to);
  }
}
