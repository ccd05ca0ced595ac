// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "folder.h"

#include <posture/core/error.h>
#include <posture/io/atomic_file.h>

#include <system_error>

namespace posture::app {

OutputFolder::OutputFolder(const std::filesystem::path& folder) {
  std::error_code error;
  const auto isThere = [&](const std::filesystem::path& part) {  // also a link to nowhere
    return std::filesystem::symlink_status(part, error).type() !=
           std::filesystem::file_type::not_found;
  };
  for (std::filesystem::path part = folder.lexically_normal(); !part.empty() && !isThere(part);
       part = part.parent_path())
    if (part.has_filename()) made_.push_back(part);
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  removeEmpty();
  throw InputError(folder.string() + ": cannot be made (" + error.message() + ")");
}

OutputFolder::~OutputFolder() { removeEmpty(); }

void OutputFolder::removeEmpty() noexcept {
  std::error_code error;
  for (const std::filesystem::path& part : made_) std::filesystem::remove(part, error);
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

void removeFrom(const std::filesystem::path& folder, const std::filesystem::path& name) {
  namespace fs = std::filesystem;
  const fs::path path = folder / name;
  std::error_code error;
  if (fs::is_regular_file(path, error) && !fs::is_symlink(path, error)) fs::remove(path, error);
}

}  // namespace posture::app
