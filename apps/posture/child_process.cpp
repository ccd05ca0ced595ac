// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "child_process.h"

#include <posture/report/table.h>

#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace posture::app {
namespace {

using Clock = std::chrono::steady_clock;

pid_t spawnSelf(const std::vector<std::string>& arguments, const std::filesystem::path& log) {
  std::vector<std::string> words{"posture"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(
      &actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t child = -1;
  // Still this program when its file has been replaced meanwhile.
  const int error = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), "starting a process");
  return child;
}

std::string lastLine(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) last = line;
  const std::string prefix = "posture: ";
  return last.rfind(prefix, 0) == 0 ? last.substr(prefix.size()) : last;
}

std::string describe(int status, const std::string& last_words) {
  std::string what;
  if (WIFSIGNALED(status))
    what = std::string("ended by a signal (") + strsignal(WTERMSIG(status)) + ")";
  else
    what = "ended with exit code " + std::to_string(WEXITSTATUS(status));
  return last_words.empty() ? what : what + ": " + last_words;
}

}  // namespace

ChildEnd runSelf(const std::vector<std::string>& arguments,
                 const std::filesystem::path& log,
                 std::chrono::duration<double> time_limit,
                 const std::function<void()>& waiting) {
  const auto start = Clock::now();
  const pid_t child = spawnSelf(arguments, log);
  int status = 0;
  bool timed_out = false;
  for (auto next_call = start; waitpid(child, &status, WNOHANG) == 0;) {
    if (Clock::now() - start > time_limit) {
      timed_out = true;
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    if (Clock::now() >= next_call) {
      waiting();
      next_call += std::chrono::milliseconds(250);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ChildEnd end;
  end.succeeded = !timed_out && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (timed_out)
    end.reason = "took longer than " + formatShort(time_limit.count()) + " s";
  else if (!end.succeeded)
    end.reason = describe(status, lastLine(log));
  std::error_code ignored;
  std::filesystem::remove(log, ignored);
  return end;
}

void endWithParent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() == 1) raise(SIGKILL);  // it ended before we asked
}

double peakMemoryMib() {
  // Not getrusage(): a program started by another inherits that one's peak.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return std::stod(line.substr(6)) / 1024;
  return 0;
}

}  // namespace posture::app
