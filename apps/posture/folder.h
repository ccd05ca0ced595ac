// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace posture::app {

/// A folder for results, made with its parents where it is not there. What was made of them goes
/// again where nothing came into it: a run that fails leaves no empty folders.
class OutputFolder {
 public:
  /// \throws InputError  it cannot be made.
  explicit OutputFolder(const std::filesystem::path& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  void removeEmpty() noexcept;

  std::vector<std::filesystem::path> made_;  // innermost first
};

/// \throws InputError  the output is one of the files that are read, or a link to one.
void requireNoInput(const std::filesystem::path& output,
                    const std::vector<std::filesystem::path>& inputs);

/// The same for several files of a folder.
void requireNoInput(const std::filesystem::path& folder,
                    const std::vector<std::string>& names,
                    const std::vector<std::filesystem::path>& inputs);

/// \throws InputError  the file could not be written.
void checkWritable(const std::filesystem::path& path);

/// Takes a file of an earlier result out of its folder, but no link: what that points to is written
/// to. What cannot be removed stays, to be written over, or for that to say why it cannot.
void removeFrom(const std::filesystem::path& folder, const std::filesystem::path& name);

}  // namespace posture::app
