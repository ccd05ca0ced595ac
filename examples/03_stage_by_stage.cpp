// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The stages of Wuhrer, Shu and Bose (2009) one after another, and what passes between them.
// Numbers are the paper's sections.
//   03_stage_by_stage SOURCE TARGET TRUTH
// Both meshes in one unit; TRUTH has a row `source_vertex target_vertex` for each known pair.
#include <posture/core/error.h>
#include <posture/deformation/common_mesh.h>
#include <posture/dense/dense_map.h>
#include <posture/evaluation/truth.h>
#include <posture/io/mesh_io.h>
#include <posture/matching/candidates.h>
#include <posture/matching/consistency.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/clean_mesh.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

using namespace posture;

// 4.1: samples, geodesic distances, the surface bent so that straight distances match these.
EmbeddedShape embed(const char* name, const TriangleMesh& mesh) {
  EmbeddedShape shape;
  shape.mesh = mesh;
  shape.landmarks = computeLandmarks(mesh, FastMarching(mesh));
  shape.form = computeCanonicalForm(shape.landmarks);
  const Eigen::Vector3d axes = shape.form.eigenvalues.cwiseSqrt();
  std::printf("%s: %d vertices, %d samples; canonical form %.3f x %.3f x %.3f, stress %.3f\n",
              name,
              static_cast<int>(mesh.vertices.rows()),
              static_cast<int>(shape.landmarks.vertices.size()),
              axes[0],
              axes[1],
              axes[2],
              shape.form.stress);
  return shape;
}

// Mean distance from the true places, over the square root of the target's area.
double meanError(const DenseMap& map,
                 const CleanMesh& source,
                 const CleanMesh& target,
                 const std::vector<VertexPair>& truth) {
  double sum = 0;
  int count = 0;
  for (const VertexPair& pair : truth) {
    const int found = map.target_vertex[source.clean_vertex[pair.source]];
    if (found < 0) continue;
    const int there = target.clean_vertex[pair.target];
    sum += (target.mesh.vertices.row(found) - target.mesh.vertices.row(there)).norm();
    ++count;
  }
  return count > 0 ? sum / count / rootArea(target.mesh) : 1;
}

int run(const char* source_path, const char* target_path, const char* truth_path) {
  const TriangleMesh source_mesh = readMesh(source_path).mesh,
                     target_mesh = readMesh(target_path).mesh;
  const CleanMesh source_clean = cleanMesh(source_mesh), target_clean = cleanMesh(target_mesh);
  const std::vector<VertexPair> truth = readTruth(truth_path,
                                                  static_cast<int>(source_mesh.vertices.rows()),
                                                  static_cast<int>(target_mesh.vertices.rows()));
  const EmbeddedShape source = embed("source", source_clean.mesh);
  const EmbeddedShape target = embed("target", target_clean.mesh);

  // 4.1: the axes of both forms are known up to their signs; an optimal assignment for each choice.
  const std::vector<Candidate> candidates = alignmentCandidates(source.form, target.form);

  // 4.2: do any two matches agree about the distance between them? c0 is learned from all.
  std::vector<Matrix> consistency;
  for (const Candidate& candidate : candidates)
    consistency.push_back(consistencyMatrix(
        candidate.matches, sampleDistances(source.landmarks), sampleDistances(target.landmarks)));
  const double threshold = consistencyThreshold(consistency);
  std::printf("%d candidates, c0 = %.3f\n\n", static_cast<int>(candidates.size()), threshold);
  std::printf("signs       E_H  matches  kernel  accepted     E_D  error\n");

  double least_energy = std::numeric_limits<double>::infinity(), least_error = 1,
         error_of_least = 1;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const Candidate& candidate = candidates[k];
    // 4.2: matches none of which contradicts another, and the map of all vertices they spread to.
    const std::vector<int> kernel = consistencyKernel(consistency[k], threshold);
    const DenseMap map = computeDenseMap(source, target, candidate, kernel, threshold);
    // 5: one mesh in both shapes; how much do its edges change in length?
    const std::vector<VertexPair> pairs =
        oneToOne(map, static_cast<int>(target.mesh.vertices.rows()));
    const CommonMeshes common = computeCommonMeshes(source.mesh, target.mesh, pairs);
    const double energy =
        std::max(deformationEnergy(common.from_source), deformationEnergy(common.from_target));

    const double error = meanError(map, source_clean, target_clean, truth);
    if (energy < least_energy) {
      least_energy = energy;
      error_of_least = error;
    }
    least_error = std::min(least_error, error);
    const auto& s = candidate.axis_signs;
    std::printf("%+d %+d %+d %6.2f  %7d  %6d  %8d  %6.3f  %.3f\n",
                s[0],
                s[1],
                s[2],
                candidate.cost,
                static_cast<int>(candidate.matches.size()),
                static_cast<int>(kernel.size()),
                static_cast<int>((map.confidence.array() > 0).count()),
                energy,
                error);
  }
  std::printf(
      "\nleast deformed: error %.3f; nearest to the truth: %.3f\n", error_of_least, least_error);
  // The least deformed may be the mirrored one. One of them is right to within a few edges.
  return least_error < 0.06 ? 0 : 1;
}

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s SOURCE TARGET TRUTH\n", argv[0]);
    return 2;
  }
  try {
    return run(argv[1], argv[2], argv[3]);
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
