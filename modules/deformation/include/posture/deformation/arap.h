// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/error.h>
#include <posture/core/types.h>
#include <posture/spectral/laplacian.h>

#include <memory>
#include <vector>

namespace posture {

/// A surface is torn to shreds: parts of it that nothing holds leave where it lies undetermined.
class TornSurface : public InputError {
 public:
  using InputError::InputError;
};

/// Deformation of a surface as rigid as possible around each vertex (Sorkine and Alexa 2007), drawn
/// towards a place for each vertex:
///   1/2 sum_i sum_j w_ij |(p_i - p_j) - R_i (q_i - q_j)|^2 + softness sum_i c_i m_i |p_i - g_i|^2
/// with q the surface at rest, R_i a rotation, w_ij cotangent weights (negative ones dropped), m_i
/// areas, g_i the goals and c_i how far each goal is to be believed.
///
/// const members may be called from several threads.
class Arap {
 public:
  Arap(const TriangleMesh& rest, const Laplacian& laplacian);
  ~Arap();
  Arap(Arap&&) noexcept;
  Arap& operator=(Arap&&) noexcept;

  /// How strongly each vertex is drawn to its goal, ready to be used many times.
  class Attraction {
   public:
    ~Attraction();
    Attraction(Attraction&&) noexcept;
    Attraction& operator=(Attraction&&) noexcept;

   private:
    friend class Arap;
    struct Impl;
    explicit Attraction(std::unique_ptr<const Impl> impl);
    std::unique_ptr<const Impl> impl_;
  };

  /// \param softness  in 1 / squared mesh units: features of a size below 1 / sqrt(softness) keep
  ///        their shape, larger ones follow the goals.
  /// \param confidence  n, >= 0; empty: all 1.
  /// \param bent  n x 3: how the surface lies so far; it then yields more easily where it is
  ///        strained already, as bodies do at their joints, and stays stiffer elsewhere. Empty:
  ///        equally stiff everywhere.
  /// \throws std::invalid_argument  numbers of vertices differ.
  /// \throws TornSurface  the system cannot be solved.
  Attraction attract(double softness, const Vector& confidence = {}, const Points& bent = {}) const;

  /// Alternates rotations and places from `start`: n x 3.
  Points pull(const Points& start,
              const Points& goals,
              const Attraction& attraction,
              int iterations) const;

  /// The least that the first sum can be where the surface lies so, after division by the area: no
  /// unit.
  double energy(const Points& bent) const;

  /// The rotation that best takes the surface at rest around each vertex to `bent`.
  std::vector<Eigen::Matrix3d> rotations(const Points& bent) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace posture
