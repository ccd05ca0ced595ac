// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "refine/club.h"
#include "refined/finalists/end_maps.h"
#include "support/shapes.h"
#include "support/unit_area.h"
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace posture {
namespace {

struct Bump {
  Eigen::Vector3d direction;
  double height, width;
};

/// A star of four limbs around the z axis, and a head above with two ears and a nose.
TriangleMesh starWithHead() {
  TriangleMesh mesh = test::sphere(5);
  std::vector<Bump> bumps{{{1, 0, 0}, 2, 0.35},
                          {{-1, 0, 0}, 2.4, 0.35},
                          {{0, 1, 0}, 2.8, 0.35},
                          {{0, -1, 0}, 3.2, 0.35},
                          {{0, 0, 1}, 1.2, 0.6},
                          {{0.3, 0, 1}, 1, 0.15},
                          {{-0.2, 0.3, 1}, 0.7, 0.12},
                          {{-0.2, -0.3, 1}, 0.7, 0.12}};
  for (auto place : mesh.vertices.rowwise()) {
    double out = 1;
    for (const Bump& bump : bumps)
      out +=
          bump.height * std::exp(-(place.transpose() - bump.direction.normalized()).squaredNorm() /
                                 (bump.width * bump.width));
    place *= out;
  }
  return test::unitArea(std::move(mesh));
}

class EndMaps : public testing::Test {
 protected:
  EndMaps() : shape_(fullSide("star", starWithHead(), false)) {
    reduceSide("source", static_cast<int>(shape_.full.vertices.rows()), shape_);
    addSpectrum("side", shape_);
    addSamples("star", shape_);
    surface_ = std::make_unique<SpectralSurface>(shape_.coarseSurface());
  }

  /// A map onto itself with what is above turned about z.
  Finalist headTurnedBy(double angle) const {
    const auto turned = [&](double by) {
      Points places = surface_->mesh.vertices;
      for (auto p : places.rowwise()) {
        const double share = std::clamp((p.z() - 0.1) / 0.1, 0.0, 1.0);
        p = (Eigen::AngleAxisd(share * by, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(p))
                .transpose();
      }
      return test::nearestOf(places, surface_->mesh);
    };
    Finalist finalist;
    finalist.maps = {turned(angle), turned(-angle)};
    return finalist;
  }

  std::vector<SampleMap> mapsFrom(const std::vector<Finalist>& finalists,
                                  const std::vector<int>& distinct) const {
    return endMaps(shape_, shape_, *surface_, *surface_, finalists, distinct);
  }

  RefinedShape shape_;
  std::unique_ptr<const SpectralSurface> surface_;
};

/// The farthest that a map of places onto themselves takes one.
double farthest(const Points& places, const std::vector<int>& map) {
  return (places - places(map, Eigen::all)).rowwise().norm().maxCoeff();
}

TEST_F(EndMaps, aHeadThatAFinalistTurnsIsNotTurned) {
  const Finalist turned = headTurnedBy(2);
  ASSERT_GT(farthest(surface_->mesh.vertices, turned.maps.forward), 0.2);
  const std::vector<SampleMap> maps = mapsFrom({turned}, {0});
  ASSERT_EQ(maps.size(), 1);
  const Points places = shape_.work.mesh.vertices(shape_.sample_vertex, Eigen::all);
  EXPECT_LT(farthest(places, maps[0].forward), 0.1);
  EXPECT_LT(farthest(places, maps[0].backward), 0.1);
}

TEST_F(EndMaps, noneComesOfAFinalistThatTurnsNoEnd) {
  EXPECT_TRUE(mapsFrom({headTurnedBy(0)}, {0}).empty());
  EXPECT_TRUE(mapsFrom({headTurnedBy(0), headTurnedBy(2)}, {0}).empty());
  EXPECT_EQ(mapsFrom({headTurnedBy(0), headTurnedBy(2)}, {0, 1}).size(), 1);
}

}  // namespace
}  // namespace posture
