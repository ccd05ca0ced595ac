// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image.h"

#include <posture/core/error.h>
#include <posture/io/atomic_file.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace posture::render {

Image shrink(const Image& image, int factor) {
  Image small(image.width / factor, image.height / factor);
  const int count = factor * factor;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      std::array<int, 3> sum{};
      for (int k = 0; k < count; ++k) {
        const std::uint8_t* pixel = image.at(x * factor + k % factor, y * factor + k / factor);
        for (int c = 0; c < 3; ++c) sum[c] += pixel[c];
      }
      for (int c = 0; c < 3; ++c)
        small.at(x, y)[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    }
  return small;
}

void paste(const Image& image, int x, int y, Image& onto) {
  const int first = std::max(0, -x);
  const int last = std::min(image.width, onto.width - x);
  if (first >= last) return;
  for (int row = std::max(0, -y); row < std::min(image.height, onto.height - y); ++row)
    std::copy_n(image.at(first, row), 3 * (last - first), onto.at(x + first, y + row));
}

double coverage(const Image& image) {
  std::size_t covered = 0;
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3)
    covered += image.pixels[i] != 255 || image.pixels[i + 1] != 255 || image.pixels[i + 2] != 255;
  return image.pixels.empty() ? 0 : 3.0 * double(covered) / double(image.pixels.size());
}

void writePng(const std::filesystem::path& path, const Image& image) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(image.pixels.begin(),
            image.pixels.end(),
            static_cast<std::uint8_t*>(data->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0)
    throw InputError(path.string() + ": the picture could not be encoded");
  AtomicFile file(path);
  file.stream().write(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                      bytes->GetNumberOfValues());
  file.commit();
}

}  // namespace posture::render
