// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/surface.h>

#include <utility>
#include <vector>

namespace posture {

/// Functional maps (Ovsjanikov et al. 2012) of both directions.
struct FunctionalMaps {
  Eigen::MatrixXf ab;  ///< k x k: functions of a times this are near those of b at the image
  Eigen::MatrixXf ba;  ///< and the other way round
};

/// One shape's functions at its own places and at the images of the other's.
struct FunctionValues {
  Eigen::MatrixXf own;       ///< n x k
  Eigen::MatrixXf on_other;  ///< n of the other x k
  Eigen::MatrixXf gram;      ///< k x k: own' W own
  Eigen::VectorXf weight;    ///< n, areas
};

/// Least squares over both maps at once (as in bijective ZoomOut, Ren et al. 2021).
FunctionalMaps fitFunctionalMaps(const FunctionValues& a, const FunctionValues& b);

/// On the first k functions of two surfaces.
FunctionalMaps fitFunctionalMaps(const SpectralSurface& a,
                                 const SpectralSurface& b,
                                 int k,
                                 const VertexMaps& maps);

/// From k functions at farthest-point samples, which stand for areas of about one size, and the map
/// between them both ways.
FunctionalMaps fitSampledMaps(const Eigen::MatrixXf& a,
                              const Eigen::MatrixXf& b,
                              const std::vector<int>& forward,
                              const std::vector<int>& backward);

/// Where both functional maps put places of either shape, in 2 k dimensions: near each other where
/// they correspond. \param a, b  k functions at the places.
std::pair<Eigen::MatrixXf, Eigen::MatrixXf> jointEmbedding(const Eigen::MatrixXf& a,
                                                           const Eigen::MatrixXf& b,
                                                           const FunctionalMaps& maps);

/// At most `size`, and as many as both surfaces have.
int basisSize(const SpectralSurface& a, const SpectralSurface& b, int size);

/// The k-th eigenvalue, mean of both: 1 / its square root is the size of what k functions hold.
double eigenvalueAt(const SpectralSurface& a, const SpectralSurface& b, int k);

/// Projection of each column on the first k eigenfunctions.
Matrix lowPass(const SpectralSurface& surface, const Matrix& values, int k);

}  // namespace posture
