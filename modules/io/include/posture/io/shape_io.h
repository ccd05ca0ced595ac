// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <filesystem>

namespace posture {

/// Reads a shape as its file has it, every point in order: every format of readMesh; PCD (0.5 to
/// 0.7: ASCII, binary, binary_compressed); and tables of numbers, told by the ending .xyz, .txt,
/// .csv, .asc, .pts, .xyzn or .xyzrgb.
///
/// A cloud's point with a coordinate that is not finite, be it NaN or infinite (some sensors say so
/// where nothing is in reach), was not seen: its row is kept, as three NaN. In a mesh it is an
/// error. A cloud's normal that is not finite becomes zero; where all are zero there are none.
///
/// PCD: fields x, y, z; normal_x, normal_y, normal_z; rgb or rgba (packed), or r, g, b. HEIGHT > 1
/// and WIDTH > 1 make a grid. VIEWPOINT's translation is the sensor, in the frame of the points, as
/// PCL's normal estimation takes it; the points are not moved, and the quaternion, which PCL's
/// normal estimation ignores too, is not used. A viewpoint at the origin, the default, is one only
/// where the points are a grid.
///
/// Tables: a row a point; numbers separated by blanks, tabs, commas or semicolons, with decimal
/// points; comments begin with # or //; a missing number between two commas is NaN. A first line
/// of names (x y z nx ny nz r g b in any order, others skipped; also behind a comment sign) says
/// what the columns are; before the rows their number may stand. Without names the columns
/// are x y z, then with
///   6: normals, or colours;
///   7: an intensity and colours (PTS), or normals or colours and something else;
///   9: normals and colours in either order;
/// which of the two, the numbers say: of unit length, or whole and from 0 to 255 (else: all from
/// 0 to 1). What is neither, and all other columns, are skipped.
/// \throws InputError  as readMesh; no point of a cloud is finite.
Shape readShape(const std::filesystem::path& path);

/// Writes PCD, PLY (both binary, in double precision where single moves points) or XYZ (text that
/// reads back as the same numbers, with a line of names where there is more than positions) by the
/// path's ending; whole or not at all. Grid and sensor are kept in PCD only.
///
/// PCD is in single precision, as PCL's own points are. Where that would move a point by more than
/// 1e-5 of the longest side of the box around them (far from the origin), positions are double: a
/// file that PCL reads into a PCLPointCloud2, but not into points such as PointXYZ, whose x, y and
/// z are floats and stay 0.
///
/// \throws InputError  cannot be written; std::invalid_argument  another ending, or parts of the
///         cloud that do not go together.
void writePointCloud(const std::filesystem::path& path, const PointCloud& cloud);

}  // namespace posture
