// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/spectral/laplacian.h>

namespace posture {

/// The smoothest functions on a surface: eigenfunctions of its Laplacian.
struct SpectralBasis {
  Matrix functions;    ///< n x k, orthonormal with respect to the mass; signs arbitrary
  Vector eigenvalues;  ///< k, increasing, the first 0; in 1 / squared mesh units
};

/// \param count  how many functions; fewer come back on a mesh with hardly more vertices.
/// \throws std::invalid_argument  fewer than three vertices, or no function asked for.
/// \throws InputError  it cannot be factorised, or the eigenvalues do not converge: a message that
///         goes behind the name of the surface.
SpectralBasis spectralBasis(const Laplacian& laplacian, int count);

}  // namespace posture
