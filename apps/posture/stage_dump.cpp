// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stage_dump.h"

#include <posture/io/mesh_io.h>
#include <posture/report/colors.h>

#include "folder.h"
#include <cstdio>
#include <string>

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

}  // namespace

StageDump::StageDump(std::filesystem::path folder) : folder_(std::move(folder)) {
  makeFolder(folder_);
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
