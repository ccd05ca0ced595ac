// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refinement/refined_pictures.h"

#include <string>

namespace posture {
std::vector<StagePicture> samplePictures(const RefinedShape& source, const RefinedShape& target) {
  std::vector<StagePicture> pictures;
  for (const auto& [side, shape] : {std::pair("source", &source), std::pair("target", &target)}) {
    const std::string name = side;
    pictures.push_back({name + "-work-mesh", shape->work.mesh, shape->work.mesh.vertices, {}});
    pictures.push_back(
        {name + "-coarse-mesh", shape->coarse.mesh, shape->coarse.mesh.vertices, {}});
    pictures.push_back({name + "-canonical-form",
                        {shape->samples.form, {}},
                        {},
                        shape->samples.confidence.rowwise().mean()});
    const int wave = std::min<int>(3, static_cast<int>(shape->basis.functions.cols()) - 1);
    pictures.push_back(
        {name + "-eigenfunction", shape->work.mesh, {}, shape->basis.functions.col(wave)});
  }
  return pictures;
}

std::vector<StagePicture> finalistPictures(const SpectralSurface& source,
                                           const SpectralSurface& target,
                                           const std::vector<Finalist>& finalists,
                                           const std::vector<int>& distinct) {
  std::vector<StagePicture> pictures{{"finalists-source", source.mesh, source.mesh.vertices, {}}};
  for (std::size_t i = 0; i < distinct.size(); ++i)
    pictures.push_back({"finalist-" + std::to_string(i) + "-target",
                        target.mesh,
                        source.mesh.vertices(finalists[distinct[i]].maps.backward, Eigen::all),
                        {}});
  return pictures;
}

std::vector<StagePicture> refinedPictures(const RefinedShape& given_source,
                                          const RefinedShape& given_target,
                                          const RefinedMap& map) {
  const SpectralSurface source = rescaled(given_source, map.scale).workSurface(),
                        target = given_target.workSurface();
  return {
      {"refined-source", source.mesh, source.mesh.vertices, {}},
      {"refined-target", target.mesh, source.mesh.vertices(map.pair.maps.backward, Eigen::all), {}},
      {"source-bent-onto-target", {map.pair.bent_a, source.mesh.faces}, source.mesh.vertices, {}},
      {"target-bent-onto-source", {map.pair.bent_b, target.mesh.faces}, map.pair.bent_b, {}}};
}

}  // namespace posture
