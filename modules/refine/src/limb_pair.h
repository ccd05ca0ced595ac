// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/turn_limbs.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace posture {

/// What of a surface is within reach of a tip; nothing where that is too small.
struct Limb {
  std::vector<int> vertex;       ///< of the whole surface
  std::vector<double> distance;  ///< of each vertex from the tip
  double reach = 0;
  std::optional<BendableSurface> surface;
};

Limb limbAt(const SpectralSurface& whole, int tip, double reach);

/// Places and normals of a limb.
struct Lie {
  Points places, normals;
};

/// Vertices of a surface with what bending costs there.
struct Part {
  const std::vector<int>& vertex;
  const Arap& arap;
};

/// How far, in distance and direction, places of some vertices of a are from their matches: one of
/// the two energies that settle() brings down. Infinite where no match is believed.
double oneWayGap(const BendableSurface& a,
                 const std::vector<int>& vertices,
                 const BendableSurface& b,
                 double softness,
                 const BentPair& pair);

/// That and the other one, of bending, on a part of a.
double oneWayMisfit(const BendableSurface& a,
                    const Part& part,
                    const BendableSurface& b,
                    double softness,
                    const BentPair& pair);

/// The end of a limb moved as a whole, and what lies between it and the body in proportion.
struct EndMove {
  Eigen::Isometry3d of_a, of_b;  ///< from how each surface lies
  double end = 0, body = 1;      ///< as those of LimbTurn
};

/// A limb of both surfaces, tried one way after another.
class LimbPair {
 public:
  LimbPair(const SpectralSurface& a,
           const SpectralSurface& b,
           int tip,
           double reach,
           double softness,
           const BentPair& pair);

  /// The other functions are for limbs.
  bool isLimb() const { return is_limb_; }

  /// Turned, and settled for a short while.
  BentPair settled(const LimbTurn& turn) const;

  /// Turned, and annealed: half as many rounds do not tell turns apart.
  BentPair annealed(const LimbTurn& turn) const;

  /// The end moved, and annealed.
  BentPair annealed(const EndMove& move) const;

  /// \param pair  of the limb, as the functions above return it.
  double misfit(const BentPair& pair) const;

  void putInto(const BentPair& limb, BentPair& whole) const;

 private:
  BentPair laid(const LimbTurn& turn) const;
  BentPair matched(const Lie& a, const Lie& b) const;
  BentPair annealed(BentPair pair) const;

  Limb a_, b_;
  bool is_limb_;
  double softness_;
  Lie lie_a_, lie_b_;
  std::vector<char> apart_a_, apart_b_;
};

/// A turn that was tried, by what is left of the misfit without it.
struct Trial {
  double misfit = 1;
  LimbTurn turn;
  BentPair limb;
};

/// All of the turns, by increasing misfit.
std::vector<Trial> trials(const LimbPair& limb, const std::vector<LimbTurn>& turns);

}  // namespace posture
