// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/map_error.h>
#include <posture/evaluation/target_metric.h>
#include <posture/evaluation/truth.h>
#include <posture/io/mesh_io.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/scan/reconstruct.h>

#include <cstdio>
#include <filesystem>
#include <numeric>

namespace {

/// Mean error of the registration, over the square root of the surface's area.
double registrationError(const std::filesystem::path& shapes) {
  const posture::TriangleMesh source = posture::readMesh(shapes / "human-pose0.ply").mesh;
  const posture::TriangleMesh target = posture::readMesh(shapes / "human-pose6.ply").mesh;
  const auto truth = posture::readTruth(shapes / "human-pose0-pose6.txt",
                                        static_cast<int>(source.vertices.rows()),
                                        static_cast<int>(target.vertices.rows()));
  const posture::RegistrationResult result = posture::registerShapes(source, target);
  if (result.status != posture::Status::REGISTERED) return 1;
  const auto error =
      measureErrors(posture::TargetMetric(target), result.correspondence.on_target, truth)
          .relative_error;
  return std::accumulate(error.begin(), error.end(), 0.0) / static_cast<double>(error.size());
}

/// Faces of the surface that PCL's Poisson reconstruction, loaded at run time, lays through points.
int poissonFaces(const std::filesystem::path& shapes) {
  posture::PointCloud cloud;
  cloud.points = posture::readMesh(shapes / "human-pose0.ply").mesh.vertices;
  posture::ReconstructionOptions options;
  options.surface = posture::SurfaceMethod::POISSON;
  return posture::reconstruct(cloud, options).summary.faces;
}

}  // namespace

/// Usage: register DATA, where DATA is the installed share/posture.
int main(int, char** argv) {
  const std::filesystem::path shapes = std::filesystem::path(argv[1]) / "human";
  const double error = registrationError(shapes);
  const int faces = poissonFaces(shapes);
  std::printf("mean error %.4f, %d faces\n", error, faces);
  // A mirrored or lost map is off by 0.1 and more.
  return error < 0.03 && faces > 1000 ? 0 : 1;
}
