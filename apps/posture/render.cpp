// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>

#include "verbs.h"
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

namespace posture::app {
namespace {

/// Becomes posture-render, a program of its own because it alone needs VTK.
[[noreturn]] void becomeRenderer(const std::vector<std::string>& arguments) {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "posture-render";
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  throw InputError(program.string() +
                   " is missing: a package of its own, or not built (POSTURE_BUILD_RENDER)");
}

}  // namespace

void addRender(CLI::App& app, Common& common) {
  CLI::App* verb = app.add_subcommand("render", "Draw meshes and clouds side by side, off screen");
  // Everything behind the verb goes to the renderer as it is, --help too.
  verb->prefix_command()->fallthrough(false)->set_help_flag();
  verb->callback([verb, &common] {
    std::vector<std::string> arguments = verb->remaining();
    if (common.json) arguments.insert(arguments.begin(), "--json");
    becomeRenderer(arguments);
  });
}

}  // namespace posture::app
