// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/geodesic/landmarks.h>

namespace posture {

/// A surface in its canonical form (Elad and Kimmel 2003): bent so that straight distances in space
/// match its geodesic ones. Centred on the samples' mean; axes are the eigenvectors of the samples'
/// covariance by decreasing eigenvalue. The sign of each axis is arbitrary.
struct CanonicalForm {
  Points landmarks;             ///< s x 3, the samples, in mesh units
  Points vertices;              ///< n x 3, every vertex
  Eigen::Vector3d eigenvalues;  ///< of the samples' covariance, squared mesh units
  double stress = 0;            ///< sqrt(sum w (d - delta)^2 / sum w delta^2)
};

/// Section 4.1 on the samples alone: `vertices` stays empty.
/// \param landmarks  as of computeLandmarks(), on a connected mesh.
/// \throws std::invalid_argument  fewer than four samples.
CanonicalForm embedSamples(const Landmarks& landmarks);

/// Section 4.1 on the samples, and every other vertex projected into their embedding.
/// \param landmarks  as for embedSamples(), which throws the same.
/// \throws std::invalid_argument  a vertex that no sample reaches.
CanonicalForm computeCanonicalForm(const Landmarks& landmarks);

}  // namespace posture
