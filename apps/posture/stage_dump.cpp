// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stage_dump.h"

#include <posture/io/mesh_io.h>
#include <posture/report/colors.h>

#include "folder.h"
#include <cstdio>
#include <string>
#include <utility>

namespace posture::app {
namespace {

Colors colorsOf(const StagePicture& picture) {
  if (picture.place.rows() > 0) return placeColors(picture.place);
  if (picture.value.size() > 0) {
    const double least = picture.value.minCoeff(), range = picture.value.maxCoeff() - least;
    return errorColors(picture.value.array() - least, range > 0 ? range : 1);
  }
  return {};
}

/// What a run before left: files named as stages are.
std::vector<std::filesystem::path> stagesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> stages;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const auto isDigit = [&](std::size_t i) { return name[i] >= '0' && name[i] <= '9'; };
    if (name.size() > 3 && isDigit(0) && isDigit(1) && name[2] == '-' &&
        entry.path().extension() == ".ply" && entry.is_regular_file())
      stages.push_back(entry.path());
  }
  return stages;
}

}  // namespace

StageDump::StageDump(std::filesystem::path folder, const std::vector<std::filesystem::path>& inputs)
    : folder_(std::move(folder)) {
  makeFolder(folder_);
  const std::vector<std::filesystem::path> before = stagesIn(folder_);
  for (const std::filesystem::path& stage : before) requireNoInput(stage, inputs);
  for (const std::filesystem::path& stage : before) std::filesystem::remove(stage);
}

void StageDump::write(const StageEvent& event) {
  if (!event.pictures) return;
  ++stages_;
  for (const StagePicture& picture : event.pictures()) {
    char number[8];
    std::snprintf(number, sizeof number, "%02d-", stages_);
    std::string name = number;
    if (!event.attempt.empty()) name += std::string(event.attempt) + '-';
    writeMesh(folder_ / (name + picture.name + ".ply"), picture.mesh, colorsOf(picture));
  }
}

}  // namespace posture::app
