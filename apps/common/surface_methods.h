// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/scan/reconstruct.h>

#include <map>
#include <string>

namespace posture::app {

/// How a surface is laid through points, as the user names it.
inline const std::map<std::string, SurfaceMethod> SURFACE_METHODS = {
    {"delaunay", SurfaceMethod::TANGENT_DELAUNAY},
    {"mls", SurfaceMethod::MLS},
    {"poisson", SurfaceMethod::POISSON},
    {"greedy", SurfaceMethod::GREEDY}};

}  // namespace posture::app
