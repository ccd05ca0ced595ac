// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "published/published_samples.h"

namespace posture {
namespace {

double meanDistance(const Landmarks& landmarks) {
  const Matrix distances = sampleDistances(landmarks);
  const Matrix weights = landmarks.confidence.cast<double>();
  return (weights.array() * distances.array()).sum() / weights.sum();
}

StagePicture sampleCloud(const std::string& side, const EmbeddedShape& shape) {
  StagePicture picture{side + "-samples", {}, {}, {}};
  const int s = static_cast<int>(shape.landmarks.vertices.size());
  picture.mesh.vertices.resize(s, 3);
  for (int i = 0; i < s; ++i)
    picture.mesh.vertices.row(i) = shape.mesh.vertices.row(shape.landmarks.vertices[i]);
  picture.value = shape.landmarks.confidence.cast<double>().rowwise().mean();
  return picture;
}

}  // namespace

double commonScale(const Landmarks& source, const Landmarks& target) {
  return meanDistance(target) / meanDistance(source);
}

void rescale(EmbeddedShape& shape, double scale) {
  shape.mesh.vertices *= scale;
  shape.landmarks.distances *= static_cast<float>(scale);
  shape.landmarks.covering_radius *= scale;
}

std::vector<StagePicture> samplePictures(const EmbeddedShape& source, const EmbeddedShape& target) {
  const auto distances = [](const std::string& side, const EmbeddedShape& shape) {
    return StagePicture{side + "-distances-from-first-sample",
                        shape.mesh,
                        {},
                        shape.landmarks.distances.row(0).transpose().cast<double>()};
  };
  return {sampleCloud("source", source),
          sampleCloud("target", target),
          distances("source", source),
          distances("target", target)};
}

std::vector<StagePicture> formPictures(const EmbeddedShape& source, const EmbeddedShape& target) {
  const auto picture = [](const std::string& side, const EmbeddedShape& shape) {
    return StagePicture{
        side + "-canonical-form", {shape.form.vertices, shape.mesh.faces}, shape.mesh.vertices, {}};
  };
  return {picture("source", source), picture("target", target)};
}

}  // namespace posture
