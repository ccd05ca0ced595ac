// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/geodesic/fast_marching.h>

#include <vector>

namespace posture {

/// Samples of a surface with what fast marching knows from each of them.
struct Landmarks {
  std::vector<int> vertices;  ///< s, in the order they were chosen: any prefix is spread evenly too
  std::vector<int> nearest;   ///< n: the sample (index into `vertices`) nearest to each vertex
  Table distances;            ///< s x n, in mesh units; infinity where not connected
  Table confidence;           ///< s x s, in [0, 1], symmetric: w of section 4.1; 1 where no path is
  double covering_radius = 0;  ///< no vertex is farther from its nearest sample, in mesh units
};

/// Voronoi (farthest-point) sampling (Eldar et al. 1997; section 4.1): each sample is the vertex
/// farthest from those before it, the first the one farthest from the centroid. Ends when no vertex
/// is farther than a mean edge length from a sample - closer samples could not be told apart - or
/// after `most` samples.
/// Fills `vertices`, `nearest` and `covering_radius` only.
/// \throws std::invalid_argument  the mesh has no faces.
Landmarks voronoiSamples(const TriangleMesh& mesh, const FastMarching& marching, int most = 1000);

/// As above, but ends at a covering radius of `spacing`, in mesh units; 0: at `most` samples or
/// when every vertex is one. \throws std::invalid_argument  the mesh has no faces.
Landmarks voronoiSamples(const TriangleMesh& mesh,
                         const FastMarching& marching,
                         int most,
                         double spacing);

/// As voronoiSamples, with all distances and the confidence of the path between each two samples,
/// w = 1 - m_h / m: of the m steps of the path (edges, or longer ones over unfolded faces, see
/// GeodesicField), m_h lie on the boundary of the surface, where the
/// path had to go round a hole.
/// \throws std::invalid_argument  the mesh has no faces.
Landmarks computeLandmarks(const TriangleMesh& mesh, const FastMarching& marching, int most = 1000);

/// Symmetric s x s distances between the samples: the mean of both directions.
Matrix sampleDistances(const Landmarks& landmarks);

}  // namespace posture
