// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/geodesic/fast_marching.h>
#include <posture/mesh/normals.h>
#include <posture/scan/reconstruct.h>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scan_shapes.h"
#include "support/shapes.h"
#include "support/topology.h"
#include <cmath>
#include <limits>
#include <numeric>
#include <omp.h>
#include <optional>
#include <string>
#include <vector>

namespace posture {
namespace {

using test::cloudOf;
using test::eulerNumber;
using test::expectManifold;

constexpr double NOTHING = std::numeric_limits<double>::quiet_NaN();

std::string refusal(const Points& points, const ReconstructionOptions& options = {}) {
  try {
    reconstruct(cloudOf(points), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Reconstruct, closesASphereAndLooksOutwards) {
  const ScanSurface surface = reconstruct(cloudOf(test::spherePoints(4000, 0.002)));
  expectManifold(surface.mesh);
  EXPECT_EQ(surface.summary.components, 1);
  EXPECT_EQ(surface.summary.boundary_loops, 0);
  EXPECT_TRUE(surface.summary.warnings.empty());
  EXPECT_EQ(eulerNumber(surface.mesh), 2);
  const Points normals = vertexNormals(surface.mesh);
  for (int v = 0; v < normals.rows(); ++v) {
    EXPECT_GT(normals.row(v).dot(surface.mesh.vertices.row(v)), 0.9);
    EXPECT_NEAR(surface.mesh.vertices.row(v).norm(), 1, 0.01);
  }
}

/// Points of a torus, without noise or with it: each goes a way of its own.
class ReconstructTorus : public testing::TestWithParam<double> {
 protected:
  static Points torus(int count, double tube) {
    const Points points = test::torusPoints(count, 1, tube);
    return points + GetParam() * tube * test::randomPoints(count, 8);
  }

  static ScanSurface reconstructed(const Points& points) {
    ScanSurface surface = reconstruct(cloudOf(points));
    EXPECT_EQ(surface.summary.through_points, GetParam() == 0);
    return surface;
  }
};
INSTANTIATE_TEST_SUITE_P(CleanAndNoisy, ReconstructTorus, testing::Values(0, 0.02));

TEST_P(ReconstructTorus, keepsItsTopology) {
  const ScanSurface surface = reconstructed(torus(6000, 0.35));
  expectManifold(surface.mesh);
  EXPECT_EQ(surface.summary.boundary_loops, 0);
  EXPECT_EQ(eulerNumber(surface.mesh), 0);
}

TEST(Reconstruct, leavesAHoleOpen) {
  const ScanSurface surface = reconstruct(cloudOf(test::planePoints(5000, 0, 0.2)));
  expectManifold(surface.mesh);
  EXPECT_EQ(surface.summary.components, 1);
  EXPECT_EQ(surface.summary.boundary_loops, 2);
  for (int f = 0; f < surface.mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d center =
        surface.mesh.vertices(surface.mesh.faces.row(f), Eigen::all).colwise().mean();
    EXPECT_GT((center - Eigen::RowVector3d(0.5, 0.5, 0)).norm(), 0.18);
  }
}

TEST(Reconstruct, takesAPlaneForAnOpenSurface) {
  const ScanSurface surface = reconstruct(cloudOf(test::planePoints(2000, 3)));
  expectManifold(surface.mesh);
  EXPECT_EQ(surface.summary.boundary_loops, 1);
  EXPECT_EQ(eulerNumber(surface.mesh), 1);
}

TEST(Reconstruct, doesNotJoinOpposingSheets) {
  // A closed box of a tenth of its width: three spacings. Its sheets are joined at the rim alone.
  Points box = test::joined(test::planePoints(1500, 0), test::planePoints(1500, 0.1, 0, 2));
  Rng rng(3);
  Points rim(600, 3);
  for (int i = 0; i < 600; ++i) {
    const double along = rng.uniform(), up = 0.1 * rng.uniform();
    const int side = i % 4;
    rim.row(i) << (side == 0   ? 0
                   : side == 1 ? 1
                               : along),
        (side == 2   ? 0
         : side == 3 ? 1
                     : along),
        up;
  }
  const ScanSurface surface = reconstruct(cloudOf(test::joined(box, rim)));
  expectManifold(surface.mesh);
  const Points& vertices = surface.mesh.vertices;
  const auto nearestTo = [&](const Eigen::RowVector3d& place) {
    Eigen::Index nearest = 0;
    (vertices.rowwise() - place).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  };
  GeodesicField field;
  FastMarching(surface.mesh).march(nearestTo({0.5, 0.5, 0}), field);
  // To the rim, up and back.
  EXPECT_NEAR(field.distance[nearestTo({0.5, 0.5, 0.1})], 1.1, 0.12);
}

/// Two upright tubes of radius 1 and `points` points each, `gap` apart. What lies less than `angle`
/// from their contact around a tube is in the crevice and not seen.
Points touchingTubes(int points, double length, double gap, double angle) {
  const auto seen = [&](const Points& tube, double x, double side) {
    std::vector<int> rows;
    for (int i = 0; i < tube.rows(); ++i)
      if (side * (tube(i, 0) - x) < std::cos(angle)) rows.push_back(i);
    return Points(tube(rows, Eigen::all));
  };
  return test::joined(seen(test::tubePoints(points, -1, 1, length, 1), -1, 1),
                      seen(test::tubePoints(points, 1 + gap, 1, length, 2), 1 + gap, -1));
}

TEST(Reconstruct, doesNotJoinTubesThatTouch) {
  // A radius of ten spacings.
  const ScanSurface surface = reconstruct(cloudOf(touchingTubes(4000, 6, 0, 0.45)));
  expectManifold(surface.mesh);
  EXPECT_EQ(surface.summary.components, 2);
  EXPECT_EQ(surface.summary.contacts, 0);
}

TEST(Reconstruct, saysWherePartsMayBeJoined) {
  // A radius of four spacings and a gap of one, with some noise: beyond telling.
  Points tubes = touchingTubes(1500, 15, 0.25, 0.45);
  Rng rng(4);
  for (int i = 0; i < tubes.size(); ++i) tubes.data()[i] += 0.02 * rng.normal();
  const ScanSurface surface = reconstruct(cloudOf(tubes));
  expectManifold(surface.mesh);
  ASSERT_EQ(surface.summary.components, 1);
  EXPECT_GT(surface.summary.contacts, 0);
  EXPECT_FALSE(surface.summary.warnings.empty());
}

TEST(Reconstruct, tellsTubesApartThatHaveNoNoise) {
  const Points tubes = touchingTubes(1500, 12, 0.25, 0.45);
  const ScanSurface surface = reconstruct(cloudOf(tubes));
  expectManifold(surface.mesh);
  int joined = 0;
  for (int c = 0; c < surface.mesh.faces.size(); ++c)
    joined += (surface.mesh.vertices(surface.mesh.faces(c / 3, c % 3), 0) < 0.125) !=
              (surface.mesh.vertices(surface.mesh.faces(c / 3, (c + 1) % 3), 0) < 0.125);
  // Half-edges: of some fifty spacings of contact few but at the ends.
  EXPECT_LT(joined, 48);
}

TEST(Reconstruct, linksPointsWithoutNoiseToTheirVertices) {
  Points points = test::torusPoints(3000, 1, 0.3);
  points.row(5) = points.row(6);
  points.row(7) << 3, 3, 3;
  points.row(8).setConstant(NOTHING);
  const Points far_away = (0.001 * points).rowwise() + Eigen::RowVector3d(20, -7, 3);
  const ScanSurface surface = reconstruct(cloudOf(far_away));
  EXPECT_EQ(surface.summary.outliers, 1);
  EXPECT_EQ(surface.on_mesh[7].vertex, -1);
  EXPECT_EQ(surface.on_mesh[8].vertex, -1);
  EXPECT_EQ(surface.on_mesh[5].vertex, surface.on_mesh[6].vertex);
  for (int i = 0; i < 3000; ++i) {
    const SurfacePoint& place = surface.on_mesh[i];
    if (i == 7 || i == 8) continue;
    ASSERT_GE(place.vertex, 0);
    EXPECT_EQ(surface.mesh.vertices.row(place.vertex), far_away.row(i));
    EXPECT_EQ(surface.offset[i], 0);
  }
}

TEST(Reconstruct, keepsPartsThatAGapCutsOff) {
  Points second = test::spherePoints(1000, 0, 2);
  second.col(0).array() += 4;
  const ScanSurface surface =
      reconstruct(cloudOf(test::joined(test::spherePoints(4000, 0), second)));
  EXPECT_EQ(surface.summary.components, 2);
  EXPECT_EQ(surface.summary.boundary_loops, 0);
}

TEST(Reconstruct, tellsWhereEachPointIs) {
  Points points = test::spherePoints(3000, 0.005);
  points.row(7).setConstant(NOTHING);
  points.row(8) << 5, 5, 5;
  points.row(9) = points.row(10);
  const ScanSurface surface = reconstruct(cloudOf(points));
  EXPECT_EQ(surface.summary.missing, 1);
  EXPECT_EQ(surface.summary.repeated, 1);
  EXPECT_GE(surface.summary.outliers, 1);
  ASSERT_EQ(surface.on_mesh.size(), 3000u);
  EXPECT_EQ(surface.on_mesh[7].vertex, -1);
  EXPECT_EQ(surface.on_mesh[8].vertex, -1);
  EXPECT_EQ(surface.on_mesh[9].face, surface.on_mesh[10].face);
  for (int i = 11; i < 3000; ++i) {
    const SurfacePoint& place = surface.on_mesh[i];
    if (place.vertex < 0) continue;
    const Eigen::RowVector3d at =
        place.barycentric.transpose() *
        Eigen::Matrix3d(surface.mesh.vertices(surface.mesh.faces.row(place.face), Eigen::all));
    EXPECT_NEAR((at - points.row(i)).norm(), surface.offset[i], 1e-12);
    EXPECT_LT(surface.offset[i], 0.05);
  }
}

TEST(Reconstruct, survivesOutliersAndNoise) {
  Rng rng(5);
  Points wild(600, 3);
  for (int i = 0; i < wild.size(); ++i) wild.data()[i] = 4 * rng.uniform() - 2;
  const ScanSurface surface =
      reconstruct(cloudOf(test::joined(test::spherePoints(6000, 0.02), wild)));
  expectManifold(surface.mesh);
  EXPECT_EQ(surface.summary.components, 1);
  const Vector radii = surface.mesh.vertices.rowwise().norm();
  EXPECT_NEAR(radii.mean(), 1, 0.01);
  EXPECT_LT((radii.array() - 1).abs().maxCoeff(), 0.1);
}

TEST(Reconstruct, looksAtTheSensorOfAView) {
  // A bowl seen from inside by a camera at the origin that looks along +z: x to the right, y down.
  constexpr int WIDTH = 60;
  const Eigen::RowVector3d center(0, 0, 3);
  Points seen = Points::Constant(WIDTH * WIDTH, 3, NOTHING);
  for (int row = 0; row < WIDTH; ++row)
    for (int column = 0; column < WIDTH; ++column) {
      const Eigen::RowVector3d ray(0.01 * (column - 29.5), 0.01 * (row - 29.5), 1);
      const double along = ray.dot(center), a = ray.squaredNorm();
      const double within = along * along - a * (center.squaredNorm() - 1);
      if (within > 0.2) seen.row(WIDTH * row + column) = (along + std::sqrt(within)) / a * ray;
    }
  struct Case {
    std::string known;
    int width;
    std::optional<Eigen::Vector3d> sensor;
  };
  const std::vector<Case> cases{
      {"the sensor", 0, Eigen::Vector3d(0, 0, 0)},
      {"the sensor of an image", WIDTH, Eigen::Vector3d(0, 0, 0)},
      {"the rows of an image", WIDTH, {}},
      // Where the origin is once the points were moved.
      {"the grid, as the sensor is among the points", WIDTH, Eigen::Vector3d(0, 0, 3.75)},
      {"the grid, as the sensor is behind what it saw", WIDTH, Eigen::Vector3d(0, 0, 8)},
      {"the grid, as the sensor is beside what it saw", WIDTH, Eigen::Vector3d(5, 0, 3)}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.known);
    PointCloud view;
    view.points = seen;
    view.width = c.width;
    view.sensor = c.sensor;
    const ScanSurface surface = reconstruct(view);
    EXPECT_TRUE(surface.summary.oriented_by_sensor);
    EXPECT_EQ(surface.summary.boundary_loops, 1);
    for (const auto& face : surface.mesh.faces.rowwise()) {
      const Eigen::RowVector3d corner = surface.mesh.vertices.row(face[0]);
      const Eigen::RowVector3d normal = (surface.mesh.vertices.row(face[1]) - corner)
                                            .cross(surface.mesh.vertices.row(face[2]) - corner);
      EXPECT_LT(normal.dot(corner), 1e-6);  // points of one column are seen edge on
    }
  }
}

/// A cap of a sphere about the origin, around its upper pole.
Points upperCap() {
  const Points sphere = test::spherePoints(8000, 0);
  std::vector<int> upper;
  for (int i = 0; i < sphere.rows(); ++i)
    if (sphere(i, 2) > 0.2) upper.push_back(i);
  return sphere(upper, Eigen::all);
}

TEST(Reconstruct, takesTheOriginForTheSensorOfPointsAheadOfIt) {
  const Points cap = upperCap();
  // Seen from within by a camera that looks along an axis of its frame; a place, which tells it.
  struct Case {
    Eigen::RowVector3d x, y, z, shift;
    bool is_asked;
  };
  const Eigen::RowVector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  for (const Case& c : std::vector<Case>{{x, y, z, 2 * z, true},
                                         {y, z, x, 2 * x, true},
                                         {z, x, y, 2 * y, false},
                                         {x, y, -z, -2 * z, false}}) {
    PointCloud cloud;
    cloud.points.resize(cap.rows(), 3);
    for (int i = 0; i < cap.rows(); ++i)
      cloud.points.row(i) = cap(i, 0) * c.x + cap(i, 1) * c.y + cap(i, 2) * c.z + c.shift;
    const ScanSurface seen = reconstruct(cloud);
    EXPECT_EQ(seen.summary.oriented_by_sensor, c.is_asked);
    const Points inward = vertexNormals(seen.mesh);
    if (c.is_asked) {
      EXPECT_LT((inward.array() * seen.mesh.vertices.array()).rowwise().sum().mean(), -0.5);
    }
    // Missing points are often written as zeros.
    PointCloud with_missing = cloud;
    with_missing.points.conservativeResize(cap.rows() + 100, 3);
    with_missing.points.bottomRows(100).setZero();
    EXPECT_EQ(reconstruct(with_missing).summary.oriented_by_sensor, c.is_asked);
    cloud.normals = cloud.points.rowwise() - c.shift;
    const ScanSurface surface = reconstruct(cloud);
    EXPECT_FALSE(surface.summary.oriented_by_sensor);
    const Points normals = vertexNormals(surface.mesh),
                 out = surface.mesh.vertices.rowwise() - c.shift;
    EXPECT_GT((normals.array() * out.array()).sum(), 0.9 * static_cast<double>(out.rows()));
  }
}

TEST(Reconstruct, keepsWhatAnotherViewThanTheSensorsShows) {
  // More than half of a ball: from above, 0.72 more looks up than down.
  const Points sphere = test::spherePoints(8000, 0);
  std::vector<int> shown;
  for (int i = 0; i < sphere.rows(); ++i)
    if (sphere(i, 2) > -0.4) shown.push_back(i);
  PointCloud cloud;
  cloud.points = sphere(shown, Eigen::all);
  cloud.sensor = Eigen::Vector3d(0, 0, 20);
  const ScanSurface surface = reconstruct(cloud);
  EXPECT_TRUE(surface.summary.oriented_by_sensor);
  EXPECT_EQ(surface.summary.outliers, 0);
  EXPECT_LT(surface.mesh.vertices.col(2).minCoeff(), -0.35);
  const Points normals = vertexNormals(surface.mesh);
  EXPECT_GT((normals.array() * surface.mesh.vertices.array()).rowwise().sum().mean(), 0.95);
}

TEST(Reconstruct, keepsClosedBodiesBeforeACameraAsTheyAre) {
  for (const double away : {1.3, 2.0, 5.0}) {
    PointCloud cloud;
    cloud.points = test::spherePoints(4000, 0).rowwise() + Eigen::RowVector3d(0, 0, away);
    const ScanSurface surface = reconstruct(cloud);
    EXPECT_EQ(surface.summary.boundary_loops, 0) << away;
    EXPECT_FALSE(surface.summary.oriented_by_sensor) << away;
  }
}

TEST(Reconstruct, asksNoSensorThatWouldSeeASpeck) {
  PointCloud cloud;
  cloud.points = upperCap();
  cloud.sensor = Eigen::Vector3d(0, 0, 20);
  EXPECT_TRUE(reconstruct(cloud).summary.oriented_by_sensor);
  // Where the origin of a map is.
  cloud.sensor = Eigen::Vector3d(0, 0, -5e4);
  const ScanSurface surface = reconstruct(cloud);
  EXPECT_FALSE(surface.summary.oriented_by_sensor);
  EXPECT_GT(vertexNormals(surface.mesh).col(2).mean(), 0);
}

TEST_P(ReconstructTorus, doesNotDependOnThreads) {
  const Points points = torus(5000, 0.3);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const ScanSurface one = reconstructed(points);
  omp_set_num_threads(4);
  const ScanSurface four = reconstructed(points);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.mesh.vertices, four.mesh.vertices);
  EXPECT_EQ(one.mesh.faces, four.mesh.faces);
  EXPECT_EQ(one.offset, four.offset);
}

TEST_P(ReconstructTorus, doesNotDependOnTheOrderOfThePoints) {
  const Points points = torus(3000, 0.3);
  const ScanSurface given = reconstructed(points);
  const ScanSurface reversed = reconstructed(points.colwise().reverse());
  EXPECT_EQ(given.mesh.vertices, reversed.mesh.vertices);
  EXPECT_EQ(given.mesh.faces, reversed.mesh.faces);
}

TEST_P(ReconstructTorus, turnsMovesAndScalesWithThePoints) {
  const Points points = torus(3000, 0.3);
  const ScanSurface given = reconstructed(points);
  const Eigen::RowVector3d way(3, -1, 2);
  for (const double unit : {1e-9, 1.0, 3e9}) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1 + unit, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    const auto moved = [&](const Points& p) -> Points {
      return unit * ((p * turn).rowwise() + way);
    };
    const ScanSurface surface = reconstructed(moved(points));
    ASSERT_EQ(surface.mesh.faces, given.mesh.faces);
    const Points off = (surface.mesh.vertices - moved(given.mesh.vertices)) / unit;
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(surface.summary.spacing / unit, given.summary.spacing, 1e-9);
  }
}

TEST_P(ReconstructTorus, placesThePointsAlikeInAnyUnit) {
  const Points points = torus(1500, 0.3);
  const ScanSurface given = reconstructed(points);
  for (const double unit : {0x1p-160, 0x1p-30, 0x1p30, 0x1p160}) {
    const ScanSurface surface = reconstructed(unit * points);
    EXPECT_EQ(surface.summary.outliers, given.summary.outliers);
    for (std::size_t i = 0; i < given.on_mesh.size(); ++i) {
      ASSERT_EQ(surface.on_mesh[i].vertex, given.on_mesh[i].vertex) << unit;
      ASSERT_NEAR(surface.offset[i] / unit, given.offset[i], 1e-12) << unit;
    }
  }
}

TEST_P(ReconstructTorus, refusesUnitsThatItCannotPlaceThePointsIn) {
  const Points points = torus(1500, 0.3);
  for (const double unit : {1e-300, 1e-160, 1e-60})
    EXPECT_EQ(refusal(unit * points), "is too small to compute with") << unit;
  for (const double unit : {1e60, 1e160, 1e290, 1e300})
    EXPECT_EQ(refusal(unit * points), "has coordinates too large to compute with") << unit;
}

TEST_P(ReconstructTorus, worksFarFromTheOriginAndBesideFarOutliers) {
  const Points points = torus(3000, 0.3);
  const Points far_away = points.rowwise() + Eigen::RowVector3d(1e6, -3e6, 2e6);
  Points outliers(2, 3);
  outliers << 1e12, 3e5, -2e7, -1e300, 4, 1e200;
  for (const Points& given : {far_away, test::joined(points, outliers)}) {
    const ScanSurface surface = reconstructed(given);
    expectManifold(surface.mesh);
    EXPECT_EQ(eulerNumber(surface.mesh), 0);
    EXPECT_EQ(surface.summary.boundary_loops, 0);
  }
}

TEST(Reconstruct, refusesWhatIsNoSurface) {
  EXPECT_EQ(refusal(Points(0, 3)), "has no points");
  EXPECT_EQ(refusal(Points::Constant(100, 3, NOTHING)), "has no point with finite coordinates");
  EXPECT_EQ(refusal(Points::Constant(100, 3, std::numeric_limits<double>::infinity())),
            "has no point with finite coordinates");
  EXPECT_EQ(refusal(Points::Constant(100, 3, 2)), "has all its points at one place");
  EXPECT_EQ(refusal(1.5e308 * test::spherePoints(100, 0)),
            "has coordinates too large to compute with");
  EXPECT_EQ(refusal(test::spherePoints(2, 0)), "has only 2 different points: a surface takes 32");
  Points line(1000, 3);
  for (int i = 0; i < 1000; ++i) line.row(i) << i, 2.0 * i, 0.1 * i;
  EXPECT_EQ(refusal(line), "has all its points on one line");
  line.rightCols(2).setZero();
  EXPECT_EQ(refusal(line), "has all its points on one line");
}

TEST(Reconstruct, refusesNormalsThatDoNotFit) {
  PointCloud cloud = cloudOf(test::spherePoints(100, 0));
  cloud.normals.resize(99, 3);
  EXPECT_THROW(reconstruct(cloud), std::invalid_argument);
}

class OtherSurfaces : public testing::TestWithParam<SurfaceMethod> {};

TEST_P(OtherSurfaces, areManifoldAndLookOutwards) {
  const ScanSurface surface = reconstruct(cloudOf(test::spherePoints(2000, 0.002)), {GetParam()});
  expectManifold(surface.mesh);
  const Points normals = vertexNormals(surface.mesh);
  int inward = 0;
  for (int v = 0; v < normals.rows(); ++v) {
    inward += normals.row(v).dot(surface.mesh.vertices.row(v)) < 0.5;
    EXPECT_NEAR(surface.mesh.vertices.row(v).norm(), 1, 0.03);
  }
  // The greedy projection folds single triangles over.
  EXPECT_LT(inward, normals.rows() / 50);
}

TEST_P(OtherSurfaces, areNotMadeOfLines) {
  Points line = Points::Zero(500, 3), circle = line;
  for (int i = 0; i < 500; ++i) {
    line(i, 0) = 0.002 * i;
    circle.row(i) << std::cos(2 * M_PI * i / 500), std::sin(2 * M_PI * i / 500), 0;
  }
  EXPECT_EQ(refusal(line, {GetParam()}), "has all its points on one line");
  EXPECT_EQ(refusal(circle, {GetParam()}), "shows no surface");
}

INSTANTIATE_TEST_SUITE_P(OfPcl,
                         OtherSurfaces,
                         testing::Values(SurfaceMethod::MLS,
                                         SurfaceMethod::POISSON,
                                         SurfaceMethod::GREEDY));

}  // namespace
}  // namespace posture
