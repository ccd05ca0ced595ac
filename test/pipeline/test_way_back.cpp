// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "refined/completion/way_back.h"
#include "sides/given_shape.h"
#include "support/shapes.h"
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// A sheet of 11 x 11 vertices, 0.1 apart, of an area of one, and a crumb far off it.
class MeasureMiss : public testing::Test {
 protected:
  static constexpr int WIDTH = 11, COUNT = WIDTH * WIDTH;

  /// Every vertex of the sheet to one so many columns on, where there is one.
  static Correspondence moved(int columns) {
    Correspondence map{std::vector<SurfacePoint>(COUNT + 3), Vector::Zero(COUNT + 3)};
    for (int v = 0; v < COUNT; ++v) {
      const int column = v % WIDTH + columns;
      if (column >= 0 && column < WIDTH) map.on_target[v].vertex = v + columns;
    }
    return map;
  }

  static TriangleMesh sheetWithCrumb() {
    const TriangleMesh sheet = test::grid(WIDTH - 1, WIDTH - 1, 1, 1);
    TriangleMesh mesh{Points(COUNT + 3, 3), Faces(sheet.faces.rows() + 1, 3)};
    mesh.vertices << sheet.vertices, 7, 7, 0, 7.1, 7, 0, 7, 7.1, 0;
    mesh.faces << sheet.faces, COUNT, COUNT + 1, COUNT + 2;
    return mesh;
  }

  WayBack measured(const Correspondence& there, const Correspondence& back) const {
    WayBack way{back, 0, 0};
    measureMiss(given_, mesh_, there, way);
    return way;
  }

  const TriangleMesh mesh_ = sheetWithCrumb();
  const CleanMesh clean_ = cleanMesh(mesh_);
  const GivenShape given_{mesh_, clean_};
};

TEST_F(MeasureMiss, ofWaysThatAgreeIsNothing) {
  for (int columns : {0, 3}) {
    const WayBack way = measured(moved(columns), moved(-columns));
    EXPECT_EQ(way.mean_miss, 0) << columns;
    EXPECT_EQ(way.percentile_95_miss, 0) << columns;
  }
}

TEST_F(MeasureMiss, isHowFarTheWayThereAndBackEndsFromItsStart) {
  const WayBack way = measured(moved(3), moved(-1));
  EXPECT_NEAR(way.mean_miss, 0.2, 1e-12);
  EXPECT_NEAR(way.percentile_95_miss, 0.2, 1e-12);
}

TEST_F(MeasureMiss, ofFewPlacesIsInTheirMeanAndTheNinetyFifthPercentile) {
  // Of the 121 vertices 11 lead 0.5 elsewhere.
  Correspondence back = moved(0);
  for (int row = 0; row < WIDTH; ++row) back.on_target[row * WIDTH].vertex += 5;
  WayBack way = measured(moved(0), back);
  EXPECT_NEAR(way.mean_miss, 0.5 / WIDTH, 1e-12);
  EXPECT_NEAR(way.percentile_95_miss, 0.5, 1e-12);
  // Now one.
  back = moved(0);
  back.on_target[0].vertex = 5;
  way = measured(moved(0), back);
  EXPECT_NEAR(way.mean_miss, 0.5 / COUNT, 1e-12);
  EXPECT_EQ(way.percentile_95_miss, 0);
}

TEST_F(MeasureMiss, leadsOnFromWithinAFaceAndFromAVertexWhereACornerLeadsNowhere) {
  // The first face is taken to its middle, of which the corners lead one column on.
  Correspondence there = moved(0), back = moved(1);
  for (SurfacePoint& place : there.on_target) place.vertex = -1;
  const int v = mesh_.faces(0, 0);
  there.on_target[v] = {v, 0, Eigen::Vector3d::Constant(1.0 / 3)};
  const Eigen::RowVector3d middle = mesh_.vertices(mesh_.faces.row(0), Eigen::all).colwise().mean(),
                           column(0.1, 0, 0);
  EXPECT_NEAR(
      measured(there, back).mean_miss, (middle + column - mesh_.vertices.row(v)).norm(), 1e-12);
  back.on_target[mesh_.faces(0, 1)].vertex = -1;
  EXPECT_NEAR(measured(there, back).mean_miss, 0.1, 1e-12);
}

TEST_F(MeasureMiss, keepsNothingOfBeforeWhereNoVertexHasBothWays) {
  WayBack way{moved(0), 0.3, 0.7};
  measureMiss(given_, mesh_, moved(COUNT), way);
  EXPECT_EQ(way.mean_miss, 0);
  EXPECT_EQ(way.percentile_95_miss, 0);
}

TEST_F(MeasureMiss, leavesTheCrumbOut) {
  Correspondence there = moved(0);
  for (int v = COUNT; v < COUNT + 3; ++v) there.on_target[v].vertex = 0;
  EXPECT_EQ(measured(there, moved(0)).mean_miss, 0);
}

}  // namespace
}  // namespace posture
