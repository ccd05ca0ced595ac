// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "display.h"

#include <posture/core/error.h>

#include <X11/Xlib.h>
#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace posture::render {
namespace {

constexpr int START_TIMEOUT_MS = 30000;

bool canConnect() {
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') return false;
  ::Display* display = XOpenDisplay(name);
  if (display == nullptr) return false;
  XCloseDisplay(display);
  return true;
}

/// Becomes an Xvfb that writes the number of its display to `report`.
[[noreturn]] void runServer(int report) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(nothing, STDERR_FILENO);
  const std::string report_text = std::to_string(report);
  execlp("Xvfb",
         "Xvfb",
         "-displayfd",
         report_text.c_str(),
         "-screen",
         "0",
         "64x64x24",
         "-nolisten",
         "tcp",
         static_cast<char*>(nullptr));
  _exit(127);
}

/// The line that the server writes when it is ready; empty when it ends or takes too long.
std::string readLine(int file) {
  std::string line;
  pollfd ready{file, POLLIN, 0};
  while (poll(&ready, 1, START_TIMEOUT_MS) > 0) {
    char c = 0;
    if (read(file, &c, 1) != 1) return {};
    if (c == '\n') return line;
    line += c;
  }
  return {};
}

void stop(pid_t server) {
  kill(server, SIGTERM);
  waitpid(server, nullptr, 0);
}

}  // namespace

Display::Display() {
  if (canConnect()) return;
  std::array<int, 2> channel{};
  if (pipe(channel.data()) != 0) throw InputError("cannot start a display: no pipe");
  server_ = fork();
  if (server_ == 0) {
    close(channel[0]);
    runServer(channel[1]);
  }
  close(channel[1]);
  const std::string number = server_ > 0 ? readLine(channel[0]) : "";
  close(channel[0]);
  if (number.empty()) {
    if (server_ > 0) stop(server_);
    throw InputError("no X display to draw with, and Xvfb (package xvfb) could not be started");
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

Display::~Display() {
  if (server_ > 0) stop(server_);
}

}  // namespace posture::render
