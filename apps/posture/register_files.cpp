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
  try {
    return registerShapes(source.shape, target.shape, options, observer);
  } catch (const InputError& error) {
    // The pipeline speaks of "source" and "target"; the user knows the files.
    const std::string message = error.what();
    for (const auto& [side, file] : {std::pair("source ", &source), std::pair("target ", &target)})
      if (message.rfind(side, 0) == 0)
        throw InputError(file->path.string() + ": " + message.substr(std::string(side).size()));
    throw;
  }
}

}  // namespace posture::app
