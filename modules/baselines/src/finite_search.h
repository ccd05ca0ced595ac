// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/search/kdtree.h>

#include <stdexcept>
#include <vector>

namespace posture {

/// A motion of a method of PCL's that is not a number.
class NoMotion : public std::runtime_error {
 public:
  NoMotion() : std::runtime_error("the motion is not a number") {}
};

/// PCL's search ends the program at places that are not finite; points are moved there where the
/// equations of a step have no solution.
/// \throws NoMotion  from such a place.
template <class Point>
class FiniteSearch : public pcl::search::KdTree<Point> {
 public:
  using pcl::search::KdTree<Point>::nearestKSearch;

  int nearestKSearch(const Point& point,
                     int count,
                     pcl::Indices& indices,
                     std::vector<float>& distances_sq) const override {
    if (!point.getVector3fMap().allFinite()) throw NoMotion();
    return pcl::search::KdTree<Point>::nearestKSearch(point, count, indices, distances_sq);
  }
};

}  // namespace posture
