// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawing.h"
#include <filesystem>
#include <string>
#include <vector>

namespace posture::render {

struct SheetOptions {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> views;  ///< of viewNames(); empty: one that is chosen from the data
  std::string up = "auto";         ///< x, y, z, -x, -y, -z, or auto
  int columns = 0;                 ///< 0: all files beside each other
  int width = 600, height = 600;   ///< of a tile, in pixels
  bool same_scale = false;
  Style style;
};

struct Tile {
  std::string file, view;
  double coverage = 0;  ///< share of its pixels that is not background
};

struct Sheet {
  Image image;
  std::vector<Tile> tiles;
};

/// \throws InputError  the sheet would be too large for a picture.
void checkSize(const SheetOptions& options);

/// One column a file, one row a view, the files' names below.
/// \param shapes  the contents of the files, in their order.
/// \throws InputError  there is nothing to draw with; a file is too large or too small to compute
///         with, or, unless all are at one
///         scale, all its tiles would be blank.
Sheet drawSheet(const std::vector<MeshFile>& shapes, const SheetOptions& options);

}  // namespace posture::render
