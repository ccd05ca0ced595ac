// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/program.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace posture::test {
namespace {

[[noreturn]] void become(const std::string& program,
                         const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment,
                         const TemporaryFolder& folder) {
  for (const std::string& entry : environment) {
    const std::size_t equals = entry.find('=');
    if (equals == std::string::npos)
      unsetenv(entry.c_str());
    else
      setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
  }
  std::signal(SIGINT, SIG_DFL);  // ignored where a shell runs the tests in the background
  if (std::freopen((folder / "out").c_str(), "w", stdout) == nullptr) _exit(126);
  if (std::freopen((folder / "err").c_str(), "w", stderr) == nullptr) _exit(126);
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  _exit(127);
}

pid_t start(const std::string& program,
            const std::vector<std::string>& arguments,
            const std::vector<std::string>& environment,
            const TemporaryFolder& folder) {
  const pid_t child = fork();
  if (child == 0) become(program, arguments, environment, folder);
  if (child < 0) throw std::runtime_error("no process");
  return child;
}

ProgramRun finish(int status, const TemporaryFolder& folder) {
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          bytesOf(folder / "out"),
          bytesOf(folder / "err")};
}

}  // namespace

ProgramRun run(const std::filesystem::path& program,
               const std::vector<std::string>& arguments,
               const std::vector<std::string>& environment) {
  const TemporaryFolder folder;
  const pid_t child = start(program.string(), arguments, environment, folder);
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw std::runtime_error("no process");
  return finish(status, folder);
}

ProgramRun runInterrupted(const std::filesystem::path& program,
                          const std::vector<std::string>& arguments,
                          int signal,
                          const std::function<bool()>& when) {
  const TemporaryFolder folder;
  const pid_t child = start(program.string(), arguments, {}, folder);
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (when()) {
      kill(child, signal);
      waitpid(child, &status, 0);
      break;
    }
    usleep(200);
  }
  return finish(status, folder);
}

bool saidWhyInOneLine(const ProgramRun& ended) {
  return ended.out.empty() && ended.err.size() > 1 && ended.err.find('\n') == ended.err.size() - 1;
}

}  // namespace posture::test
