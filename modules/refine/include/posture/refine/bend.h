// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/sample_maps.h>
#include <posture/refine/surface.h>

#include <vector>

namespace posture {

/// The map of all vertices that a map of samples stands for: one functional map each way
/// (Ovsjanikov et al. 2012) on the first `size` eigenfunctions, then nearest neighbours.
/// \param samples_a, samples_b  eigenfunctions at the samples, as in SampledShape.
VertexMaps spreadToVertices(const SpectralSurface& a,
                            const SpectralSurface& b,
                            const Eigen::MatrixXf& samples_a,
                            const Eigen::MatrixXf& samples_b,
                            const SampleMap& map,
                            int size);

/// Registers two surfaces from an approximate map. For each size of basis in turn: functional maps
/// both ways; each surface bent as rigidly as possible onto its image, the more freely the larger
/// the basis; then nearest neighbours where eigenfunctions, places and normals all agree, in a
/// space in which a distance sees both directions (in the spirit of Eisenberger, Laehner and
/// Cremers 2020).
VertexMaps bend(const SpectralSurface& a,
                const SpectralSurface& b,
                const std::vector<int>& sizes,
                VertexMaps maps);

/// As bend(), with the places and normals that the basis itself can hold instead of bent surfaces:
/// follows detail that no rigid bending explains.
VertexMaps sharpen(const SpectralSurface& a,
                   const SpectralSurface& b,
                   const std::vector<int>& sizes,
                   VertexMaps maps);

}  // namespace posture
