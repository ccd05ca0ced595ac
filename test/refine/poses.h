// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/geodesic/landmarks.h>
#include <posture/refine/sample_maps.h>
#include <posture/refine/surface.h>
#include <posture/synthesis/articulated_body.h>

#include <cstdint>
#include <vector>

namespace posture::test {

/// The mesh at an area of one, with its first functions.
SpectralSurface spectralSurface(TriangleMesh mesh, int functions);

/// Two poses of one body on the same triangulation of about 1000 vertices: the true map takes every
/// vertex to the one of the same number.
struct Poses {
  ArticulatedBody body_a, body_b;
  SpectralSurface a, b;
};

/// Made once.
const Poses& poses(BodyKind kind);

VertexMaps identity(const SpectralSurface& surface);

/// Left for right.
VertexMaps mirrored(const Poses& of);

/// The identity, every vertex moved along so many edges at random.
VertexMaps perturbed(const Poses& of, int steps, std::uint64_t seed);

/// How far a map of a surface is from the identity, straight, in mean edge lengths.
double meanError(const SpectralSurface& target, const std::vector<int>& map);

/// size x size, orthogonal.
Matrix randomRotation(int size, std::uint64_t seed);

/// Evenly spread samples, as the pipeline takes them.
struct Samples {
  Samples(const SpectralSurface& surface, int count);

  Landmarks landmarks;
  SampledShape shape;
};

}  // namespace posture::test
