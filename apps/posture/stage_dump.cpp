// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stage_dump.h"

#include <posture/io/atomic_file.h>
#include <posture/io/mesh_io.h>
#include <posture/io/text_file.h>
#include <posture/report/colors.h>

#include <cstdio>
#include <sstream>
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

const char* const LIST = "stages.txt";

/// Whether a stage may be written under this name.
bool isNameOfStage(const std::string& name) {
  const auto isDigit = [&](std::size_t i) { return name[i] >= '0' && name[i] <= '9'; };
  return name.size() > 3 && isDigit(0) && isDigit(1) && name[2] == '-';
}

/// What the list of a run before names, and nothing else, is taken away.
void removeStages(const std::filesystem::path& folder) {
  // Without a word in it, as power failures may leave it: no list.
  if (!std::filesystem::exists(folder / LIST) || std::filesystem::is_empty(folder / LIST)) return;
  std::istringstream list(readTextFile(folder / LIST));
  for (std::string name; std::getline(list, name);)
    if (isNameOfStage(name) && std::filesystem::path(name).filename() == name)
      std::filesystem::remove(folder / name);
}

}  // namespace

StageDump::StageDump(std::filesystem::path folder, const std::vector<std::filesystem::path>& inputs)
    : folder_(std::move(folder)), output_(folder_) {
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    if (isNameOfStage(entry.path().filename().string())) requireNoInput(entry.path(), inputs);
  requireNoInput(folder_ / LIST, inputs);
  checkWritable(folder_ / LIST);  // now, not after minutes
  removeStages(folder_);
}

void StageDump::write(const StageEvent& event) {
  if (!event.pictures) return;
  ++stages_;
  const std::vector<StagePicture> pictures = event.pictures();
  if (pictures.empty()) return;
  std::vector<std::string> names;
  for (const StagePicture& picture : pictures) {
    char number[8];
    std::snprintf(number, sizeof number, "%02d-", stages_);
    std::string name = number;
    if (!event.attempt.empty()) name += std::string(event.attempt) + '-';
    names.push_back(name + picture.name + ".ply");
    list_ += names.back() + '\n';
  }
  writeFile(folder_ / LIST, list_);
  for (std::size_t i = 0; i < pictures.size(); ++i)
    writeMesh(folder_ / names[i], pictures[i].mesh, colorsOf(pictures[i]));
}

}  // namespace posture::app
