// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include "points/spacing.h"
#include <vector>

namespace posture {

/// Where directions that tell the outside come from.
enum class HintSource {
  NONE,
  NORMALS,  ///< given with the points: of either sign, or of no sign at all
  GRID,     ///< the depth image, as it is seen: noisy, the side is certain
  SENSOR,   ///< exact if the scanner stood there (sensorView()): the way from the points to it
};

struct OutsideHints {
  Points directions;  ///< n x 3: unit vectors that point outwards, zero where unknown; or 0 x 3
  HintSource source = HintSource::NONE;
  Eigen::RowVector3d sensor = Eigen::RowVector3d::Zero();  ///< its place, where it is the source
  bool is_assumed = false;        ///< at the origin, of which nothing tells
  Points normals = Points(0, 3);  ///< given ones, for where the sensor did not see the points
};

/// What they tell of some of the points.
OutsideHints rowsOf(const OutsideHints& hints, const std::vector<int>& rows);

/// What is left to go by where the sensor did not see the points: their normals, or nothing.
OutsideHints withoutSensor(const OutsideHints& hints);

/// What a sensor that is said to stand somewhere saw of points from there.
struct SensorView {
  /// Whether a sensor saw points from where it is said to be: a part of them looks towards it as a
  /// whole, or, with all its normals turned round, away from it. Both sides of closed bodies fill
  /// the same part of its view; views that were put into one file, or moved and kept the place of
  /// the scanner, look any way.
  bool is_seen = false;
  bool is_only_one = false;  ///< hardly any of them was seen from elsewhere
};

/// \param normals  of consistent sign in each part.
/// \param part_of  n: a number for each part.
SensorView sensorView(const OutsideHints& hints,
                      const Points& points,
                      const Points& normals,
                      const Spacing& spacing,
                      const std::vector<int>& part_of);

struct OrientationSummary {
  bool by_sensor = false;
  bool is_one_view = false;  ///< told by poleNormals() only
  bool by_normals = false;
};

/// Gives normals the signs that make neighbours agree (Hoppe et al. 1992: along a minimum spanning
/// tree), and each connected part of the points its outside.
OrientationSummary orientNormals(const Points& points,
                                 const NeighborTable& neighbors,
                                 const Spacing& spacing,
                                 const OutsideHints& hints,
                                 Points& normals);

/// Whether the normals of some points, consistent among themselves, have to be turned round.
bool looksInward(const Points& points,
                 const Points& normals,
                 const std::vector<int>& part,
                 const Spacing& spacing,
                 const OutsideHints& hints,
                 OrientationSummary& summary);

}  // namespace posture
