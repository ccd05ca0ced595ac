// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sheet.h"

#include <posture/core/computable.h>
#include <posture/core/error.h>

#include "caption.h"
#include <algorithm>
#include <cmath>

namespace posture::render {
namespace {

constexpr int CAPTION_SIZE = 14;
constexpr int CAPTION_HEIGHT = 28;
constexpr double MARGIN = 0.06;        // of a tile's side, all round
constexpr double LARGEST_SHEET = 2e8;  // pixels

/// Where the tiles are, in pixels from the lower left corner.
struct Layout {
  int columns, rows_per_block, blocks, width, height;

  int sheetWidth() const { return columns * width; }
  int sheetHeight() const { return blocks * blockHeight(); }
  int blockHeight() const { return rows_per_block * height + CAPTION_HEIGHT; }
  int left(int file) const { return file % columns * width; }
  int captionBottom(int file) const { return sheetHeight() - (file / columns + 1) * blockHeight(); }
  int bottom(int file, int row) const {
    return captionBottom(file) + CAPTION_HEIGHT + (rows_per_block - 1 - row) * height;
  }
};

Layout layoutOf(const SheetOptions& options) {
  const int files = static_cast<int>(options.files.size());
  const int columns = options.columns > 0 ? std::min(options.columns, files) : files;
  const int rows = std::max<int>(1, static_cast<int>(options.views.size()));
  return {columns, rows, (files + columns - 1) / columns, options.width, options.height};
}

std::vector<Eigen::Vector3d> upsOf(const std::string& name,
                                   const std::vector<const Points*>& shapes) {
  if (name == "auto") return guessUps(shapes);
  const double sign = name.front() == '-' ? -1 : 1;
  return {shapes.size(), sign * Eigen::Vector3d::Unit(name.back() - 'x')};
}

/// views[row][file].
std::vector<std::vector<View>> viewsOf(const std::vector<Points>& points,
                                       const SheetOptions& options) {
  std::vector<const Points*> shapes;
  shapes.reserve(points.size());
  for (const Points& shape : points) shapes.push_back(&shape);
  const std::vector<Eigen::Vector3d> ups = upsOf(options.up, shapes);
  if (options.views.empty()) return {chosenViews(shapes, ups)};
  std::vector<std::vector<View>> views(options.views.size());
  for (std::size_t row = 0; row < views.size(); ++row)
    for (const Eigen::Vector3d& up : ups) views[row].push_back(namedView(options.views[row], up));
  return views;
}

/// Widened to the tile's proportions and margin.
Window fitted(Window window, const SheetOptions& options) {
  const double aspect = double(options.width) / options.height;
  const double half = std::max(window.half_height, window.half_width / aspect) / (1 - 2 * MARGIN);
  window.half_height = half > 0 ? half : 1;
  window.half_width = window.half_height * aspect;
  return window;
}

/// windows[row][file].
std::vector<std::vector<Window>> windowsOf(const std::vector<Points>& points,
                                           const std::vector<std::vector<View>>& views,
                                           const SheetOptions& options) {
  std::vector<std::vector<Window>> windows(views.size());
  double largest = 0;
  for (std::size_t row = 0; row < views.size(); ++row)
    for (std::size_t file = 0; file < points.size(); ++file) {
      windows[row].push_back(fitted(windowAround(points[file], views[row][file]), options));
      largest = std::max(largest, windows[row].back().half_height);
    }
  if (options.same_scale)
    for (auto& row : windows)
      for (Window& window : row) {
        window.half_width *= largest / window.half_height;
        window.half_height = largest;
      }
  return windows;
}

/// The file's name, with its folder where another file has the same name.
std::string nameOf(std::size_t file, const SheetOptions& options) {
  const std::filesystem::path& path = options.files[file];
  for (std::size_t other = 0; other < options.files.size(); ++other)
    if (options.files[other].filename() == path.filename() && options.files[other] != path)
      return (path.parent_path().filename() / path.filename()).string();
  return path.filename().string();
}

/// One shape beyond what can be computed with would spoil the views of all.
void requireComputable(const Points& points, const std::filesystem::path& file) {
  if (points.rows() == 0) return;
  try {
    requireNotTooLarge(points.cwiseAbs().maxCoeff());
    requireNotTooSmall((points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff());
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

void pasteCaption(
    const std::string& text, int left, int bottom, const Layout& layout, Image& onto) {
  const Image line = caption(text, CAPTION_SIZE, layout.width - 16);
  paste(line,
        left + (layout.width - line.width) / 2,
        bottom + (CAPTION_HEIGHT - line.height) / 2,
        onto);
}

}  // namespace

void checkSize(const SheetOptions& options) {
  const Layout layout = layoutOf(options);
  const double width = double(layout.columns) * layout.width;
  const double height =
      double(layout.blocks) * (double(layout.rows_per_block) * layout.height + CAPTION_HEIGHT);
  if (width * height > LARGEST_SHEET)
    throw InputError("the picture would have " + std::to_string(std::lround(width)) + " x " +
                     std::to_string(std::lround(height)) + " pixels: fewer or smaller tiles?");
}

Sheet drawSheet(const std::vector<MeshFile>& shapes, const SheetOptions& options) {
  std::vector<Points> points;
  points.reserve(shapes.size());
  for (const MeshFile& shape : shapes) {
    points.push_back(visiblePoints(shape, options.style));
    requireComputable(points.back(), options.files[points.size() - 1]);
  }
  const auto views = viewsOf(points, options);
  const auto windows = windowsOf(points, views, options);
  const Layout layout = layoutOf(options);

  Sheet sheet;
  sheet.image = Image(layout.sheetWidth(), layout.sheetHeight());
  Canvas canvas(options.width, options.height);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Drawing drawing(shapes[i], options.style);
    const int file = static_cast<int>(i);
    bool shows = false;
    for (std::size_t row = 0; row < views.size(); ++row) {
      const Image tile = canvas.draw(drawing, views[row][i], windows[row][i]);
      const int bottom = layout.bottom(file, static_cast<int>(row));
      paste(tile, layout.left(file), bottom, sheet.image);
      const std::string view = options.views.empty() ? "chosen" : options.views[row];
      sheet.tiles.push_back({options.files[i].string(), view, coverage(tile)});
      shows = shows || sheet.tiles.back().coverage > 0;
      if (options.views.size() < 2) continue;
      const Image label = caption(view, CAPTION_SIZE - 2, layout.width - 16);
      paste(label, layout.left(file) + 8, bottom + layout.height - label.height - 8, sheet.image);
    }
    // At one scale with others it may be too small to be seen.
    if (!shows && !options.same_scale)
      throw InputError(options.files[i].string() + ": there is nothing to see");
    pasteCaption(
        nameOf(i, options), layout.left(file), layout.captionBottom(file), layout, sheet.image);
  }
  return sheet;
}

}  // namespace posture::render
