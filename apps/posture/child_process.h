// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace posture::app {

/// How a child process ended.
struct ChildEnd {
  bool succeeded = false;
  bool is_known = false;  ///< false: somebody else took it
  std::string reason;     ///< otherwise, in one line: what it said last, the signal, the time limit
};

/// Runs this very program with other arguments, in a process of its own: its memory is its own, and
/// what crashes or hangs it leaves us alive. Arguments `--parent PID` are added after the
/// first, its verb, for endWithParent(). `waiting` is called a few times a second.
/// \throws std::system_error  no process could be made.
ChildEnd runSelf(const std::vector<std::string>& arguments,
                 std::chrono::duration<double> time_limit,
                 const std::function<void()>& waiting);

/// In a child: be ended with the parent, whichever way that ends.
/// \param parent  its process id: where it has ended already another is the parent. That is not
/// always the process 1, which in a container may itself be ours.
void endWithParent(int parent);

}  // namespace posture::app
