// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/point_cloud.h>
#include <posture/core/types.h>
#include <posture/scan/reconstruct.h>

#include <optional>
#include <vector>

namespace posture {

/// Gives every place of a shape its colour: smooth over the shape and different at its far ends and
/// on its two sides. The colour is a place in the principal axes of the shape it was made for, so
/// equal places get equal colours wherever they are asked for; what lies far off has those of its
/// ends. What is not finite is no place, and grey.
class PlaceColoring {
 public:
  /// \param vertices  n x 3: the shape.
  explicit PlaceColoring(const Points& vertices);

  Colors operator()(const Points& places) const;

 private:
  Eigen::RowVector3d centre_ = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();   // columns, widest first
  Eigen::RowVector3d low_ = Eigen::RowVector3d::Zero();  // along the axes
  Eigen::RowVector3d high_ = Eigen::RowVector3d::Zero();
};

/// The vertices' own colouring.
Colors placeColors(const Points& vertices);

/// What has no counterpart or no value.
inline constexpr std::uint8_t REJECTED_GREY = 180;

/// `colors` (one a source vertex) with grey where the source vertex has no counterpart.
Colors greyWhereRejected(Colors colors, const Correspondence& correspondence);

/// Colours of the target: the mean of those of the source vertices that lie there. A source vertex
/// inside a face of the target colours the face's corners, by its barycentric coordinates. Grey
/// where nothing lies. \throws std::invalid_argument  numbers of colours and places differ; a place
/// is not on the target.
Colors transferColors(const Colors& source,
                      const Correspondence& correspondence,
                      const TriangleMesh& target);

/// The same for a shape as it was given. \param scan  the surface laid through a target that is a
/// cloud, which faces refer to.
Colors transferColors(const Colors& source,
                      const Correspondence& correspondence,
                      const Shape& target,
                      const std::optional<ScanSurface>& scan);

/// One colour a part, strong and few, so that parts that touch differ and large ones are told apart
/// best.
/// \param count  of the parts, some of which may have no vertex.
/// \param label  n: part of each vertex, the largest first; -1: none.
/// \throws std::invalid_argument  a part beyond `count`.
Colors partPalette(int count, const std::vector<int>& label, const Faces& faces);

/// Each vertex (point) in its part's colour; grey where it has none.
/// \throws std::invalid_argument  a part without a colour.
Colors partColors(const std::vector<int>& label, const Colors& palette);

/// Dark blue for 0 by green to yellow for `largest` and beyond (viridis); grey for NaN.
/// \throws std::invalid_argument  largest <= 0.
Colors errorColors(const Vector& errors, double largest);

}  // namespace posture
