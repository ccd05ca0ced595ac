// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/rigid_motion.h>

#include <gtest/gtest.h>

#include "refined/completion/loose_pieces.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture::test {

/// A crooked limb, one unit long, with two knobs on its end: that fits in one way only.
inline TriangleMesh crookedLimb() {
  TriangleMesh mesh = test::sphere(4);
  for (auto p : mesh.vertices.rowwise()) {
    const auto knob = [&](const Eigen::RowVector3d& at, double height, double width) {
      return height * std::exp(-(p - at).squaredNorm() / (width * width));
    };
    const double along = 0.5 * (p.z() + 1),
                 knobs = 1 + knob({0.8, 0, 0.6}, 1.2, 0.3) + knob({-0.3, 0.75, 0.59}, 0.8, 0.2);
    p = Eigen::RowVector3d(0.12 * knobs * p.x() + 0.25 * along * along,
                           0.12 * knobs * p.y() + 0.1 * std::sin(4 * along),
                           along);
  }
  return mesh;
}

/// A limb, and the same without a band, so that its end is a piece: all vertices keep their
/// numbers.
class LimbInTwo : public testing::Test {
 protected:
  static constexpr double FROM = 0.6, TO = 0.66, TRUST = 0.8, SCALE = 2;

  LimbInTwo() {
    for (int f = 0; f < whole_.faces.rows(); ++f) {
      const auto face = whole_.faces.row(f);
      const auto isIn = [&](int v) { return inBand(v); };
      if (std::any_of(face.begin(), face.end(), isIn))
        cut_.faces.row(f).setConstant(face[0]);  // no face
    }
    cut_clean_ = cleanMesh(cut_);
  }

  bool inBand(int v) const { return whole_.vertices(v, 2) > FROM && whole_.vertices(v, 2) < TO; }
  bool isBeyond(int v) const { return whole_.vertices(v, 2) >= TO; }

  /// Farther from the gap than that.
  bool isWellInside(int v) const { return whole_.vertices(v, 2) > TO + 3 * edge_; }

  /// One side laid onto the other exactly, as far as its main surface goes; the rest stays behind.
  LaidSide laid(const Eigen::Isometry3d& motion, double scale) const {
    const auto n = whole_.vertices.rows();
    LaidSide side{scale,
                  TRUST,
                  {std::vector<SurfacePoint>(n), Vector::Zero(n)},
                  moved(motion, scale * whole_.vertices)};
    for (int v = 0; v < n; ++v)
      if (whole_.vertices(v, 2) <= FROM) {
        side.correspondence.on_target[v].vertex = v;
        side.correspondence.confidence[v] = TRUST;
      } else {
        side.deformed.row(v).setZero();
      }
    return side;
  }

  TriangleMesh movedWhole() const {
    return {moved(motion_, SCALE * whole_.vertices), whole_.faces};
  }

  const TriangleMesh whole_ = crookedLimb();
  const CleanMesh whole_clean_ = cleanMesh(whole_);
  TriangleMesh cut_ = whole_;
  CleanMesh cut_clean_;
  const double edge_ = meanEdgeLength(whole_);
  const Eigen::Isometry3d motion_ =
      Eigen::Translation3d(5, -2, 1) * Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized());
};

}  // namespace posture::test
