// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "register_files.h"

#include <posture/core/error.h>

#include <string>
#include <utility>

namespace posture::app {

RegistrationResult registerFiles(const ShapeFile& source,
                                 const ShapeFile& target,
                                 const RegistrationOptions& options,
                                 const Observer& observer) {
  return registerFiles(source.path, source.shape, target.path, target.shape, options, observer);
}

RegistrationResult registerFiles(const std::filesystem::path& source_path,
                                 const Shape& source,
                                 const std::filesystem::path& target_path,
                                 const Shape& target,
                                 const RegistrationOptions& options,
                                 const Observer& observer) {
  try {
    return registerShapes(source, target, options, observer);
  } catch (const InputError& error) {
    // The pipeline speaks of "source" and "target"; the user knows the files.
    const std::string message = error.what();
    for (const auto& [side, path] :
         {std::pair("source ", &source_path), std::pair("target ", &target_path)})
      if (message.rfind(side, 0) == 0)
        throw InputError(path->string() + ": " + message.substr(std::string(side).size()));
    throw InputError(source_path.string() + " onto " + target_path.string() + ": " + message);
  }
}

}  // namespace posture::app
