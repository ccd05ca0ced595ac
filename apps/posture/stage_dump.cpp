// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stage_dump.h"

#include <posture/io/mesh_io.h>
#include <posture/report/colors.h>

#include "folder.h"
#include <cstdio>
#include <string>
#include <vector>

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

/// NN-name.ply
bool isDumped(const std::string& name) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  return name.size() > 7 && isDigit(name[0]) && isDigit(name[1]) && name[2] == '-' &&
         name.substr(name.size() - 4) == ".ply";
}

}  // namespace

StageDump::StageDump(std::filesystem::path folder) : folder_(std::move(folder)) {
  makeFolder(folder_);
  std::vector<std::filesystem::path> earlier;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    if (isDumped(entry.path().filename().string())) earlier.push_back(entry.path());
  for (const auto& path : earlier) std::filesystem::remove(path);
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
