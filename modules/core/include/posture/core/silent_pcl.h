// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/console/print.h>

namespace posture {

/// While it lives, PCL does not write to the terminal, of the whole process: what it has to say is
/// in the results. For modules that link PCL; core itself does not.
class SilentPcl {
 public:
  SilentPcl() : before_(pcl::console::getVerbosityLevel()) {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~SilentPcl() { pcl::console::setVerbosityLevel(before_); }
  SilentPcl(const SilentPcl&) = delete;
  SilentPcl& operator=(const SilentPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL before_;
};

}  // namespace posture
