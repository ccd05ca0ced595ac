// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>

#include <array>
#include <cstddef>
#include <vector>

namespace posture {

/// How soft surfaces are when they settle, on any resolution: as the finest eigenfunctions are.
/// From the eigenvalues of both shapes.
double settlingSoftness(const Vector& eigenvalues_a, const Vector& eigenvalues_b);
double settlingSoftness(const SpectralSurface& a, const SpectralSurface& b);

/// Lets two surfaces that lie nearly on each other settle: in turn bends each as rigidly as
/// possible towards its image, to places in faces, and moves each vertex's match along the other
/// surface to where places and normals agree best, seen from both sides at once.
/// \param softness  as for Arap::attract.
void settle(const BendableSurface& a,
            const BendableSurface& b,
            double softness,
            int rounds,
            BentPair& pair);

/// Shares of the softness by which surfaces settle, stiff, then soft, and the rounds of each.
inline constexpr std::array<double, 3> SETTLING{0.1, 0.3, 1};
inline constexpr int SETTLING_ROUNDS = 6;

/// Settles by one of SETTLING after the other. \param first  the one to begin with.
void settleSoftening(const BendableSurface& a,
                     const BendableSurface& b,
                     double softness,
                     BentPair& pair,
                     std::size_t first = 0);

/// As settle(), with long strides (heavy ball method, Polyak 1964): sliding along a surface,
/// matches go most of the way in the first rounds and the rest of it slowly. For maps without grave
/// mistakes, which settle() mends better.
///
/// \param softness  nearly that which surfaces show: they yield to pulls 1.8 times as long.
///
/// \throws TornSurface  nothing holds a part of a surface; settle() as well
void polish(const BendableSurface& a,
            const BendableSurface& b,
            double softness,
            int rounds,
            BentPair& pair);

/// Polishes from stiff to soft.
/// \param softness  that of the end.
void anneal(const BendableSurface& a, const BendableSurface& b, double softness, BentPair& pair);

/// A place in a face, by its corners in the order the mesh names them.
struct FacePoint {
  int face = -1;
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();  ///< >= 0, sum 1
};

/// For each vertex of a the place on b that fits it best, in the faces around its match.
std::vector<FacePoint> placesOnFaces(const BendableSurface& a,
                                     const BendableSurface& b,
                                     double softness,
                                     const BentPair& pair);

}  // namespace posture
