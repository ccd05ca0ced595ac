// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <Eigen/Geometry>

#include <vector>

namespace posture {

/// The shape of a mesh, each vertex told relative to a polygon of vertices near it (Kraevoy and
/// Sheffer 2006, "Mean-value geometry encoding"). With A = 1/2 sum_k p_k x p_(k+1) the area vector
/// of the polygon, n = A / |A| its normal and s the root mean square distance of its corners from
/// their centroid, vertex i lies at
///   v_i = sum_k w_k p_k + offset_i s n,
/// w the mean-value coordinates (Floater 2003) of v_i among the corners, all projected along n.
/// Weights and offsets are the same for any rotated, moved and scaled copy.
///
/// What the publication leaves open is settled so:
/// - The polygon is the ring of neighbours; at a boundary it is closed by the segment between its
///   ends.
/// - Vertices outside their polygon have negative weights, by angles with sign (Hormann and
///   Floater 2006); a vertex on a side has those of the side's ends.
/// - Where that is no sound frame - the ring is folded or nearly collinear (its area vector short
///   beside its faces or its radius), has two vertices only, or the weights cancel (absolute values
///   sum to more than 5), or the mesh is no manifold at the vertex - the polygon is a triangle: the
///   neighbour farthest from the neighbours' centroid, the one farthest from that, the one farthest
///   from their line. If these are nearly collinear too, neighbours of neighbours join in until
///   they are not. Mean-value coordinates in a triangle are barycentric ones.
/// - Offsets are in units of s, which does not vanish where a polygon collapses.
struct MeanValueEncoding {
  /// A vertex in the frame (tangent, bitangent, normal) of another one's polygon, in its unit s.
  struct Step {
    int vertex;
    int from;                 ///< -1: the first vertex of a connected part
    Eigen::Vector3d place;    ///< relative to `from`
    Eigen::Quaterniond turn;  ///< from the frame of `from` to that of `vertex`
    double ratio;             ///< of their units
  };

  std::vector<int> first;      ///< n + 1: where each vertex's polygon begins
  std::vector<int> corner;     ///< vertices, in the order of the polygon
  std::vector<double> weight;  ///< as corner; those of a vertex sum to 1
  Vector offset;               ///< n
  std::vector<Step> layout;    ///< each vertex after the one it is placed from; if asked for

  int vertexCount() const { return static_cast<int>(offset.size()); }
};

/// \param with_layout  as decodeMeanValues() asks for; otherwise layout stays empty.
/// \throws InputError  a connected part lies within a line, or is too small to compute with;
///         std::invalid_argument  a vertex in no face.
MeanValueEncoding encodeMeanValues(const TriangleMesh& mesh, bool with_layout = true);

/// v_i minus where the encoding would have it, and how that changes with v_i (always the identity)
/// and with the corners.
struct MeanValueResidual {
  Eigen::Vector3d value;
  std::vector<Eigen::Matrix3d> by_corner;
};

/// \param place, corners  where vertex `i` and its polygon's corners are now.
/// \param with_jacobian  otherwise by_corner stays empty.
MeanValueResidual meanValueResidual(const MeanValueEncoding& encoding,
                                    int i,
                                    const Eigen::Vector3d& place,
                                    const std::vector<Eigen::Vector3d>& corners,
                                    bool with_jacobian);

/// The shape of an encoding, some of its vertices at given places: the least sum of squared
/// residuals, by Levenberg and Marquardt's method. It starts from the vertices laid out one after
/// the other, each in the frame of the one before (as in Lipman et al. 2005), and turned, moved and
/// scaled onto the fixed ones.
///
/// Three vertices out of line determine a shape up to what the encoding does not see: a flat part
/// can be sheared and stretched in its plane.
/// \param fixed  vertices, none twice.
/// \param places  one row each.
/// \param start  n x 3, to start from instead; empty: none.
/// \throws std::invalid_argument  a connected part with fewer than three fixed vertices, or all in
///         one line; an encoding without a layout.
Points decodeMeanValues(const MeanValueEncoding& encoding,
                        const std::vector<int>& fixed,
                        const Points& places,
                        const Points& start = {});

}  // namespace posture
