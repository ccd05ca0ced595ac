// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "common/surface_methods.h"
#include <string>

namespace posture::app {

inline std::string nameOf(SurfaceMethod method) {
  for (const auto& [name, value] : SURFACE_METHODS)
    if (value == method) return name;
  return {};
}

/// --surface: how a surface is laid through points.
inline void addSurfaceOption(CLI::App* verb, SurfaceMethod& method) {
  verb->add_option_function<std::string>(
          "--surface",
          [&method](const std::string& name) { method = SURFACE_METHODS.at(name); },
          "How a surface is laid through points: delaunay (the default), mls, poisson or greedy "
          "(PCL's, for comparison)")
      ->check(CLI::IsMember(SURFACE_METHODS));
}

}  // namespace posture::app
