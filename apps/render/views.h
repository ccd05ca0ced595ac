// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <string>
#include <vector>

namespace posture::render {

/// How one looks at a shape: the picture's axes in the data's coordinates, orthonormal.
struct View {
  Eigen::Vector3d right, up, toward_viewer;
};

/// The names that namedView() knows: front, back, left, right, top, bottom, three-quarter.
const std::vector<std::string>& viewNames();

/// The direction that is up in each shape: the one in which it stands on the broadest footprint,
/// along an axis of the data where one of them will do. It is the same for all shapes, but for
/// those that hardly stand in it and do in another: these seem to have a frame of their own.
std::vector<Eigen::Vector3d> guessUps(const std::vector<const Points*>& shapes);

/// A view relative to the data's own axes: with y up, the front is where z grows; with z up, where
/// y falls; with x up, where y grows.
View namedView(const std::string& name, const Eigen::Vector3d& up);

/// One view a shape, from comparable sides: upright, slightly from above, and across the horizontal
/// direction in which the shapes with this `up` spread least. A shape that would be seen from its
/// narrow side is looked at from its own broad one.
std::vector<View> chosenViews(const std::vector<const Points*>& shapes,
                              const std::vector<Eigen::Vector3d>& ups);

}  // namespace posture::render
