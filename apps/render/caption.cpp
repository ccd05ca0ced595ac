// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "caption.h"

#include <posture/core/utf8.h>

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace posture::render {
namespace {

constexpr int DPI = 72;

/// Printable ASCII and well-formed longer sequences as they are, anything else as '?'.
std::string readable(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = characterLength(text, i);
    const bool good = length > 0 && lead >= 0x20 && lead != 0x7F;
    result += good ? text.substr(i, length) : "?";
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

/// The text without `dropped` characters in its middle.
std::string shortened(const std::string& text, std::size_t dropped) {
  if (dropped == 0) return text;
  std::size_t begin = (text.size() - std::min(dropped, text.size())) / 2;
  std::size_t end = std::min(text.size(), begin + dropped);
  while (begin > 0 && isContinuation(text[begin])) --begin;
  while (end < text.size() && isContinuation(text[end])) ++end;
  return text.substr(0, begin) + "..." + text.substr(end);
}

bool fits(vtkTextProperty* style, const std::string& text, int width) {
  std::array<int, 4> box{};
  return vtkFreeTypeTools::GetInstance()->GetBoundingBox(
             style, vtkStdString(text), DPI, box.data()) &&
         box[1] - box[0] + 1 <= width;
}

}  // namespace

Image caption(const std::string& text, int size, int width) {
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();
  style->SetFontSize(size);
  style->SetColor(0.25, 0.25, 0.25);
  const std::string whole = readable(text);
  std::size_t dropped = 0;
  while (dropped < whole.size() && !fits(style, shortened(whole, dropped), width)) ++dropped;

  vtkNew<vtkImageData> drawn;
  std::array<int, 2> extent{};
  vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
  tools->ScaleToPowerTwoOff();
  if (!tools->RenderString(
          style, vtkStdString(shortened(whole, dropped)), DPI, drawn, extent.data()))
    return {};
  Image image(extent[0], extent[1]);
  std::array<int, 6> bounds{};
  drawn->GetExtent(bounds.data());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto* rgba =
          static_cast<std::uint8_t*>(drawn->GetScalarPointer(bounds[0] + x, bounds[2] + y, 0));
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] =
            static_cast<std::uint8_t>((rgba[c] * rgba[3] + 255 * (255 - rgba[3]) + 127) / 255);
    }
  return image;
}

}  // namespace posture::render
