// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "child_process.h"

#include <posture/report/table.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <spawn.h>
#include <sstream>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace posture::app {
namespace {

using Clock = std::chrono::steady_clock;

/// A file without a name: it goes with whoever has it open last.
using Log = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Log makeLog() {
  Log log(std::tmpfile(), std::fclose);
  if (log == nullptr) throw std::system_error(errno, std::generic_category(), "a temporary file");
  return log;
}

/// How children end is told to us while this lives: where SIGCHLD is ignored, as a parent of ours
/// may have left it, the system forgets that.
class ToldOfChildren {
 public:
  ToldOfChildren() {
    struct sigaction action = {};
    action.sa_handler = SIG_DFL;
    sigaction(SIGCHLD, &action, &before_);
  }
  ~ToldOfChildren() { sigaction(SIGCHLD, &before_, nullptr); }
  ToldOfChildren(const ToldOfChildren&) = delete;
  ToldOfChildren& operator=(const ToldOfChildren&) = delete;

 private:
  struct sigaction before_ = {};
};

/// \param log  takes the stderr of the process.
pid_t spawnSelf(const std::vector<std::string>& arguments, std::FILE* log) {
  std::vector<std::string> words{"posture"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.begin() + 2, {"--parent", std::to_string(getpid())});
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(log), STDERR_FILENO);
  pid_t child = -1;
  // Still this program when its file has been replaced meanwhile.
  const int error = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), "starting a process");
  return child;
}

std::string lastLine(std::FILE* log) {
  std::rewind(log);
  std::string words, last;
  for (int c = std::fgetc(log); c != EOF; c = std::fgetc(log)) words += static_cast<char>(c);
  std::istringstream stream(words);
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
                 std::chrono::duration<double> time_limit,
                 const std::function<void()>& waiting) {
  const auto start = Clock::now();
  const Log log = makeLog();
  const ToldOfChildren told;
  const pid_t child = spawnSelf(arguments, log.get());
  int status = 0;
  pid_t ended = 0;
  bool timed_out = false;
  for (auto next_call = start; (ended = waitpid(child, &status, WNOHANG)) == 0;) {
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
  end.is_known = timed_out || ended == child;
  end.succeeded = !timed_out && ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (timed_out)
    end.reason = "took longer than " + formatShort(time_limit.count()) + " s";
  else if (!end.is_known)
    end.reason = std::string("how it ended is not known (") + std::strerror(errno) + ")";
  else if (!end.succeeded)
    end.reason = describe(status, lastLine(log.get()));
  return end;
}

void endWithParent(int parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) raise(SIGKILL);  // it ended before we asked
}

}  // namespace posture::app
