// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "folder.h"

#include <posture/core/error.h>
#include <posture/io/atomic_file.h>

#include <system_error>

namespace posture::app {

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string() + ": cannot be made (" + error.message() + ")");
}

void requireNoInput(const std::filesystem::path& output,
                    const std::vector<std::filesystem::path>& inputs) {
  std::error_code error;
  for (const std::filesystem::path& input : inputs)
    if (std::filesystem::equivalent(input, output, error))
      throw InputError(input.string() + ": would be written over by the output");
}

void requireNoInput(const std::filesystem::path& folder,
                    const std::vector<std::string>& names,
                    const std::vector<std::filesystem::path>& inputs) {
  for (const std::string& name : names) requireNoInput(folder / name, inputs);
}

void checkWritable(const std::filesystem::path& path) { const AtomicFile probe(path); }

void writeText(const std::filesystem::path& path, const std::string& text) {
  writeFile(path, text);
}

}  // namespace posture::app
