// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace posture::render {

/// RGB, 8 bits each, rows from the bottom up as OpenGL and VTK have them.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< 3 * width * height

  Image() = default;
  Image(int columns, int rows) : width(columns), height(rows) {
    pixels.assign(std::size_t{3} * columns * rows, 255);
  }
  std::uint8_t* at(int x, int y) { return &pixels[3 * (std::size_t(y) * width + x)]; }
  const std::uint8_t* at(int x, int y) const { return &pixels[3 * (std::size_t(y) * width + x)]; }
};

/// Mean over squares of `factor` x `factor` pixels; both sides divisible by it.
Image shrink(const Image& image, int factor);

/// Copies `image` so that its lower left corner comes to (x, y); what lies outside is dropped.
void paste(const Image& image, int x, int y, Image& onto);

/// Share of pixels that are not white.
double coverage(const Image& image);

/// \throws InputError  cannot be written; nothing is left then.
void writePng(const std::filesystem::path& path, const Image& image);

}  // namespace posture::render
