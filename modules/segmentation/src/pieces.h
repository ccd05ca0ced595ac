// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <Eigen/Geometry>

#include "joint.h"
#include "sliding_fit.h"
#include <map>
#include <vector>

namespace posture {

/// A body at rest and on its surfaces in some poses.
struct PosedBody {
  PosedBody(const TriangleMesh& at_rest,
            const std::vector<Points>& places,
            const Vector& face_areas);

  const TriangleMesh& rest;
  const Vector& areas;  // of the faces
  Points normals;       // at rest
  std::vector<PosedSurface> poses;
};

/// What distance along the surface counts for a set of faces, that across it being 1.
double weightAlong(double area);

/// The vertices of faces, with their share of the area.
std::vector<WeighedVertex> verticesOf(const PosedBody& body, const std::vector<int>& faces);

/// A surface in pieces, each moved as rigidly as fits the poses.
class Pieces {
 public:
  /// \param label  piece of each face.
  Pieces(const PosedBody& body, const std::vector<int>& label);

  /// By how much pieces that touch turn against each other, in radians, root mean square over the
  /// poses.
  std::vector<double> turns() const;

  /// Merges those that turn by less, or by no more than noise makes them, or of which one is small.
  void mergeBelow(double turn);

  /// Piece of each face, that of the largest area first.
  std::vector<int> labels() const;

 private:
  struct Piece {
    std::vector<int> faces;
    double area = 0;
    Stiffness stiffness;
    std::vector<Eigen::Isometry3d> motion;  // one a pose
    double misfit = 0;                      // of all poses
    std::map<int, Border> adjacent;
  };
  struct Pair {
    double cost = 0, turn = 0;
  };

  void fit(Piece& piece, const std::vector<Eigen::Isometry3d>& start) const;
  std::vector<Eigen::Isometry3d> commonMotion(const Piece& a, const Piece& b) const;
  Pair pairOf(int a, int b) const;
  static bool isNoise(const Piece& a, const Piece& b, double cost);
  bool belongTogether(int a, int b, const Pair& pair, double turn) const;
  void merge(int a, int b);

  const PosedBody& body_;
  double total_area_ = 0;
  std::map<int, Piece> pieces_;
};

}  // namespace posture
