// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include <filesystem>

namespace posture::app {

/// A shape and the file it was read from.
struct ShapeFile {
  std::filesystem::path path;
  Shape shape;
};

/// registerShapes(), naming the file where one of the shapes cannot be used.
RegistrationResult registerFiles(const ShapeFile& source,
                                 const ShapeFile& target,
                                 const RegistrationOptions& options,
                                 const Observer& observer);

/// The same of shapes that others keep.
RegistrationResult registerFiles(const std::filesystem::path& source_path,
                                 const Shape& source,
                                 const std::filesystem::path& target_path,
                                 const Shape& target,
                                 const RegistrationOptions& options = {},
                                 const Observer& observer = {});

}  // namespace posture::app
