// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/vertex_neighbors.h>
#include <posture/registration/isometric_registration.h>
#include <posture/synthesis/simulated_scan.h>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pcl/common/centroid.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/registration/transformation_estimation_svd.h>
#include <pcl/registration/transformation_estimation_svd_scale.h>

#include "registration/pcl_bodies.h"
#include "support/bodies.h"
#include "support/motions.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace posture {
namespace {

using pcl::PointXYZRGBNormal;
using testing::HasSubstr;
using testing::StartsWith;
using Cloud = pcl::PointCloud<PointXYZRGBNormal>;
using Registration = IsometricRegistration<PointXYZRGBNormal, PointXYZRGBNormal>;
using Base = pcl::Registration<PointXYZRGBNormal, PointXYZRGBNormal>;

constexpr double NONE = std::numeric_limits<double>::max();

/// Two poses, registered once as meshes; everything that was seen on the way.
struct Registered {
  ArticulatedBody source_body = test::body(0, 1000), target_body = test::body(2, 1000, 1);
  double edge = meanEdgeLength(target_body.mesh);
  Cloud::Ptr source = test::toColoredCloud(source_body.mesh);
  Cloud::Ptr target = test::toColoredCloud(target_body.mesh);
  Registration registration;
  Cloud output, shown;
  pcl::Indices shown_rows, shown_matches;
  int calls = 0;
  bool watching = false;
  std::string printed;
  std::vector<double> progress;

  Registered() {
    source->header.frame_id = "camera";
    registration.setSourceMesh(source, test::toPolygons(source_body.mesh.faces));
    registration.setTargetMesh(target, test::toPolygons(target_body.mesh.faces));
    std::function<Base::UpdateVisualizerCallbackSignature> callback =
        [this](const Cloud& cloud, const pcl::Indices& rows, const Cloud&, const pcl::Indices& t) {
          if (!watching) return;  // copies have the callback too
          shown = cloud;
          shown_rows = rows;
          shown_matches = t;
          ++calls;
        };
    registration.registerVisualizationCallback(callback);
    registration.setObserver([this](const StageEvent& event) {
      if (watching) progress.push_back(event.progress);
    });
    watching = true;  // the base calls it when it is registered
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    registration.align(output);
    printed = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
    watching = false;
  }
};

const Registered& registered() {
  static Registered once;
  return once;
}

/// A copy to call what is not const, as all of PCL's accessors.
Registration copyOfRegistered() { return registered().registration; }

double squaredDistance(const PointXYZRGBNormal& a, const PointXYZRGBNormal& b) {
  return (a.getVector3fMap() - b.getVector3fMap()).cast<double>().squaredNorm();
}

double nearestSquared(const PointXYZRGBNormal& point, const Cloud& cloud) {
  double least = NONE;
  for (const PointXYZRGBNormal& other : cloud)
    least = std::min(least, squaredDistance(point, other));
  return least;
}

Eigen::Affine3d similarity() {
  return Eigen::Translation3d(3, -1, 2) *
         Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(2.5);
}

TEST(IsometricRegistration, outputIsTheSourceWhereItsCounterpartsAre) {
  const Registered& r = registered();
  EXPECT_TRUE(r.registration.hasConverged()) << r.registration.getMessage();
  EXPECT_EQ(r.registration.getResult().status, Status::REGISTERED);
  ASSERT_EQ(r.output.size(), r.source->size());
  double miss = 0, before = 0, agreement = 0;
  const std::vector<VertexPair> truth = groundTruth(r.source_body, r.target_body);
  for (const VertexPair& pair : truth) {
    const PointXYZRGBNormal &found = r.output[pair.source], &there = (*r.target)[pair.target];
    miss += std::sqrt(squaredDistance(found, there));
    before += std::sqrt(squaredDistance((*r.source)[pair.source], there));
    agreement += found.getNormalVector3fMap().dot(there.getNormalVector3fMap());
  }
  const auto count = static_cast<double>(truth.size());
  EXPECT_LT(miss / count, r.edge);
  EXPECT_GT(before / count, 2 * r.edge);
  // Neighbouring normals of so coarse a mesh differ by about 20 degrees.
  EXPECT_GT(agreement / count, std::cos(0.35));
}

TEST(IsometricRegistration, otherFieldsAndHeaderAreKeptAndNormalsStayUnits) {
  const Registered& r = registered();
  EXPECT_EQ(r.output.header.frame_id, "camera");
  for (std::size_t i = 0; i < r.output.size(); ++i) {
    ASSERT_EQ(r.output[i].rgba, (*r.source)[i].rgba);
    ASSERT_EQ(r.output[i].curvature, (*r.source)[i].curvature);
    ASSERT_NEAR(r.output[i].getNormalVector3fMap().norm(), 1, 1e-5);
    ASSERT_EQ(r.output[i].data[3], 1);
  }
}

TEST(IsometricRegistration, resultHasTheSameInDoublePrecision) {
  const Registered& r = registered();
  const Points& places = r.registration.getResult().deformed;
  ASSERT_EQ(places.rows(), static_cast<Eigen::Index>(r.output.size()));
  for (int i = 0; i < places.rows(); ++i)
    ASSERT_EQ(r.output[i].getVector3fMap(), places.row(i).transpose().cast<float>());
  EXPECT_EQ(r.registration.getMessage(), r.registration.getResult().message);
  EXPECT_THAT(r.registration.getMessage(), HasSubstr("counterpart"));
}

TEST(IsometricRegistration, observerIsToldOfTheProgress) {
  const std::vector<double>& progress = registered().progress;
  ASSERT_GT(progress.size(), 10);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_GE(progress.front(), 0);
  EXPECT_GT(progress.back(), 0.5);
  EXPECT_LE(progress.back(), 1);
}

TEST(IsometricRegistration, whatAnObserverThrowsLeavesAlignWithoutAnAnswer) {
  struct Cancelled : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  Registration registration = copyOfRegistered();
  ASSERT_TRUE(registration.hasConverged());
  registration.setObserver([](const StageEvent& event) {
    if (event.stage == "spectrum") throw Cancelled("enough");
  });
  Cloud output;
  EXPECT_THROW(registration.align(output), Cancelled);
  EXPECT_FALSE(registration.hasConverged());
  EXPECT_TRUE(registration.getCorrespondences()->empty());
  EXPECT_THAT(registration.getMessage(), HasSubstr("observer"));
}

TEST(IsometricRegistration, printsNothing) { EXPECT_EQ(registered().printed, ""); }

TEST(IsometricRegistration, correspondencesNumberBothClouds) {
  const Registered& r = registered();
  const pcl::Correspondences& matches = *r.registration.getCorrespondences();
  EXPECT_GT(matches.size(), 0.9 * static_cast<double>(r.source->size()));
  std::map<int, int> truth;
  for (const VertexPair& pair : groundTruth(r.source_body, r.target_body))
    truth[pair.source] = pair.target;
  double miss = 0;
  for (const pcl::Correspondence& match : matches) {
    ASSERT_LT(match.index_match, static_cast<int>(r.target->size()));
    const PointXYZRGBNormal& found = (*r.target)[match.index_match];
    const double distance_sq = squaredDistance(r.output[match.index_query], found);
    EXPECT_NEAR(match.distance, distance_sq, 1e-5 * r.edge);
    miss += std::sqrt(squaredDistance(found, (*r.target)[truth.at(match.index_query)]));
  }
  EXPECT_LT(miss / static_cast<double>(matches.size()), r.edge);
}

TEST(IsometricRegistration, finalTransformationIsTheBestRigidMotionOfTheMatches) {
  const Registered& r = registered();
  Registration registration = copyOfRegistered();
  Eigen::Matrix4f by_pcl;
  pcl::registration::TransformationEstimationSVD<PointXYZRGBNormal, PointXYZRGBNormal>()
      .estimateRigidTransformation(
          *r.source, *r.target, *registration.getCorrespondences(), by_pcl);
  EXPECT_TRUE(registration.getFinalTransformation().isApprox(by_pcl, 1e-4f));
  EXPECT_EQ(registration.getLastIncrementalTransformation(), registration.getFinalTransformation());
  EXPECT_NEAR((by_pcl.topLeftCorner<3, 3>().determinant()), 1, 1e-5);
}

TEST(IsometricRegistration, fitnessJudgesTheDeformedPoints) {
  const Registered& r = registered();
  Registration registration = copyOfRegistered();
  std::vector<double> distances_sq;
  for (const PointXYZRGBNormal& point : r.output)
    distances_sq.push_back(nearestSquared(point, *r.target));
  const auto meanBelow = [&](double range) {
    double sum = 0;
    int count = 0;
    for (double d : distances_sq)
      if (d <= range) sum += d, ++count;
    return sum / count;
  };
  EXPECT_NEAR(registration.getFitnessScore(), meanBelow(NONE), 1e-4 * meanBelow(NONE));
  std::nth_element(distances_sq.begin(), distances_sq.begin() + 200, distances_sq.end());
  const double range = 1.0001 * distances_sq[200];  // of squared distances, as in PCL
  EXPECT_NEAR(registration.getFitnessScore(range), meanBelow(range), 1e-3 * meanBelow(range));
  EXPECT_EQ(registration.getFitnessScore(-1), NONE);
}

TEST(IsometricRegistration, fitnessThroughTheBaseJudgesTheRigidPart) {
  const Registered& r = registered();
  Registration registration = copyOfRegistered();
  Base& base = registration;
  double sum = 0;
  for (PointXYZRGBNormal point : *r.source) {
    point.getVector4fMap() = registration.getFinalTransformation() * point.getVector4fMap();
    sum += nearestSquared(point, *r.target);
  }
  sum /= static_cast<double>(r.source->size());
  EXPECT_NEAR(base.getFitnessScore(), sum, 1e-3 * sum);
  EXPECT_GT(base.getFitnessScore(), 2 * registration.getFitnessScore());
}

TEST(IsometricRegistration, callbackIsShownTheDeformedSource) {
  const Registered& r = registered();
  EXPECT_EQ(r.calls, 1);
  EXPECT_TRUE(test::sameBytes(r.shown, r.output));
  const pcl::Correspondences& matches = *r.registration.getCorrespondences();
  ASSERT_EQ(r.shown_rows.size(), matches.size());
  ASSERT_EQ(r.shown_matches.size(), matches.size());
  for (std::size_t i = 0; i < matches.size(); ++i) {
    EXPECT_EQ(r.shown_rows[i], matches[i].index_query);
    EXPECT_EQ(r.shown_matches[i], matches[i].index_match);
  }
}

TEST(IsometricRegistration, deformTakesOtherPointsAlong) {
  const Registered& r = registered();
  EXPECT_TRUE(test::sameBytes(r.registration.deform(*r.source), r.output));
  // Markers in the middle of faces end near them, with their normals and colours.
  Cloud markers;
  const Faces& faces = r.source_body.mesh.faces;
  for (int f = 0; f < faces.rows(); f += 50) {
    PointXYZRGBNormal marker = (*r.source)[faces(f, 0)];
    marker.getVector3fMap().setZero();
    for (int k = 0; k < 3; ++k)
      marker.getVector3fMap() += (*r.source)[faces(f, k)].getVector3fMap() / 3;
    markers.push_back(marker);
  }
  markers.push_back(PointXYZRGBNormal());
  markers.back().x = std::numeric_limits<float>::quiet_NaN();
  const Cloud carried = r.registration.deform(markers);
  ASSERT_EQ(carried.size(), markers.size());
  EXPECT_TRUE(std::isnan(carried.back().x));
  for (std::size_t i = 0; i + 1 < markers.size(); ++i) {
    const int corner = faces(50 * static_cast<int>(i), 0);
    EXPECT_LT(std::sqrt(squaredDistance(carried[i], r.output[corner])), 2 * r.edge);
    EXPECT_EQ(carried[i].rgba, markers[i].rgba);
    EXPECT_NEAR(carried[i].getNormalVector3fMap().norm(), 1, 1e-5);
  }
}

TEST(IsometricRegistration, copiesShareNothingThatChanges) {
  const Registered& r = registered();
  Registration original = r.registration, copy = original, assigned;
  assigned = original;
  for (Registration* other : {&copy, &assigned}) {
    EXPECT_NE(other->getIndices(), original.getIndices());
    EXPECT_NE(other->getSearchMethodTarget(), original.getSearchMethodTarget());
    EXPECT_NE(other->getSearchMethodSource(), original.getSearchMethodSource());
    EXPECT_NE(other->getCorrespondences(), original.getCorrespondences());
    EXPECT_TRUE(other->hasConverged());
    EXPECT_EQ(other->getFitnessScore(), original.getFitnessScore());
    Base &base = *other, &original_base = original;
    EXPECT_EQ(base.getFitnessScore(), original_base.getFitnessScore());
  }
  // A copy registers to something else, in another unit, from a guess; the original stays.
  const TriangleMesh target = test::moved(r.source_body.mesh, similarity());
  const Cloud::Ptr other_target = test::toColoredCloud(target);
  copy.setTargetMesh(other_target, test::toPolygons(target.faces));
  EXPECT_FALSE(copy.hasConverged());
  EXPECT_EQ(copy.getFitnessScore(), NONE);
  EXPECT_TRUE(copy.getCorrespondences()->empty());
  EXPECT_TRUE(copy.deform(*r.source).empty());
  Cloud output;
  copy.align(output);
  EXPECT_TRUE(copy.hasConverged()) << copy.getMessage();
  EXPECT_NEAR(copy.getResult().scale, 2.5, 0.01);
  double miss = 0;
  for (std::size_t i = 0; i < output.size(); ++i)
    miss += std::sqrt(squaredDistance(output[i], (*other_target)[i]));
  EXPECT_LT(miss / static_cast<double>(output.size()), 0.1 * meanEdgeLength(target));

  // Rotation alone in the matrix; with the scale PCL finds it from the matches.
  const Eigen::Matrix3f turn = similarity().rotation().cast<float>();
  EXPECT_TRUE((copy.getFinalTransformation().topLeftCorner<3, 3>().isApprox(turn, 0.01f)));
  Eigen::Matrix4f scaled;
  pcl::registration::TransformationEstimationSVDScale<PointXYZRGBNormal, PointXYZRGBNormal>()
      .estimateRigidTransformation(*r.source, *other_target, *copy.getCorrespondences(), scaled);
  EXPECT_TRUE(scaled.isApprox(similarity().matrix().cast<float>(), 0.01f));

  EXPECT_TRUE(original.hasConverged());
  EXPECT_EQ(original.getResult().deformed, r.registration.getResult().deformed);
  EXPECT_EQ(original.getCorrespondences()->size(), r.registration.getCorrespondences()->size());
}

TEST(IsometricRegistration, twoThreadsAndAGuessGiveTheSameAnswer) {
  const Registered& r = registered();
  Registration first = copyOfRegistered(), second = copyOfRegistered();
  Cloud one, two;
  std::thread thread([&] { first.align(one); });
  second.align(two, similarity().matrix().cast<float>());
  thread.join();
  EXPECT_TRUE(test::sameBytes(one, r.output));
  EXPECT_TRUE(test::sameBytes(two, r.output));
  EXPECT_TRUE(first.hasConverged() && second.hasConverged());
}

TEST(IsometricRegistration, indicesNameThePointsThatTakePart) {
  const Registered& r = registered();
  Registration registration = copyOfRegistered();
  // Backwards, without every thirtieth point, one of them twice.
  auto indices = pcl::make_shared<pcl::Indices>();
  for (int i = static_cast<int>(r.source->size()) - 1; i >= 0; --i)
    if (i % 30 != 0) indices->push_back(i);
  indices->push_back(indices->front());
  registration.setIndices(indices);
  EXPECT_FALSE(registration.hasConverged());
  Cloud output;
  registration.align(output);
  ASSERT_TRUE(registration.hasConverged()) << registration.getMessage();
  ASSERT_EQ(output.size(), indices->size());
  EXPECT_EQ(output.width, output.size());
  EXPECT_EQ(output.height, 1);
  std::map<int, int> truth;
  for (const VertexPair& pair : groundTruth(r.source_body, r.target_body))
    truth[pair.source] = pair.target;
  double miss = 0;
  for (std::size_t i = 0; i < output.size(); ++i) {
    ASSERT_EQ(output[i].rgba, (*r.source)[(*indices)[i]].rgba);
    miss += std::sqrt(squaredDistance(output[i], (*r.target)[truth.at((*indices)[i])]));
  }
  EXPECT_LT(miss / static_cast<double>(output.size()), r.edge);
  EXPECT_TRUE(output.back().getVector3fMap() == output.front().getVector3fMap());
  std::size_t row = 0;
  for (const pcl::Correspondence& match : *registration.getCorrespondences()) {
    while (row < indices->size() && (*indices)[row] != match.index_query) ++row;
    ASSERT_LT(row, indices->size()) << "in the order of the indices";
    EXPECT_NEAR(match.distance,
                squaredDistance(output[row], (*r.target)[match.index_match]),
                1e-5 * r.edge);
  }
}

TEST(IsometricRegistration, organisedMeshesKeepTheirGridAndWhatWasNotSeen) {
  const Registered& r = registered();
  // The vertices in a grid, every fourth of whose points was not seen.
  const auto grid = [](const Cloud& from, std::vector<pcl::Vertices>& polygons) {
    auto cloud = pcl::make_shared<Cloud>();
    cloud->width = 40;
    cloud->height = static_cast<std::uint32_t>(from.size() / 30 + 1);
    PointXYZRGBNormal missing;
    missing.x = missing.y = missing.z = std::numeric_limits<float>::quiet_NaN();
    cloud->points.assign(static_cast<std::size_t>(cloud->width) * cloud->height, missing);
    cloud->is_dense = false;
    for (std::size_t i = 0; i < from.size(); ++i) (*cloud)[i / 3 * 4 + i % 3] = from[i];
    for (pcl::Vertices& polygon : polygons)
      for (auto& corner : polygon.vertices) corner = corner / 3 * 4 + corner % 3;
    return cloud;
  };
  std::vector<pcl::Vertices> source_polygons = test::toPolygons(r.source_body.mesh.faces),
                             target_polygons = test::toPolygons(r.target_body.mesh.faces);
  const Cloud::Ptr source = grid(*r.source, source_polygons);
  const Cloud::Ptr target = grid(*r.target, target_polygons);
  Registration registration;
  registration.setSourceMesh(source, source_polygons);
  registration.setTargetMesh(target, target_polygons);
  Cloud output;
  registration.align(output);
  EXPECT_TRUE(registration.hasConverged()) << registration.getMessage();
  EXPECT_EQ(output.width, source->width);
  EXPECT_EQ(output.height, source->height);
  EXPECT_FALSE(output.is_dense);
  for (std::size_t i = 0; i < source->size(); ++i)
    ASSERT_EQ(std::isnan(output[i].x), std::isnan((*source)[i].x));
  // What was seen is what the same mesh gave without the gaps.
  for (std::size_t i = 0; i < r.source->size(); ++i)
    ASSERT_EQ(output[i / 3 * 4 + i % 3].getVector3fMap(), r.output[i].getVector3fMap());
  const auto placed = [](int i) { return i / 3 * 4 + i % 3; };
  const pcl::Correspondences &found = *registration.getCorrespondences(),
                             &expected = *r.registration.getCorrespondences();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].index_query, placed(expected[i].index_query));
    ASSERT_EQ(found[i].index_match, placed(expected[i].index_match));
  }
  EXPECT_NEAR(registration.getFitnessScore(), copyOfRegistered().getFitnessScore(), 1e-9);
}

TEST(IsometricRegistration, organisedPointsKeepTheirGridAndWhatWasNotSeen) {
  ScanOptions options;
  options.views = 1;
  options.points = 2500;
  const auto view = [&](int pose) {
    const SimulatedScan scan = scanBody(test::body(pose, 1000), options);
    const auto cloud = test::toCloud<PointXYZRGBNormal>(scan.cloud.points);
    cloud->width = scan.cloud.width;
    cloud->height = static_cast<std::uint32_t>(cloud->size() / cloud->width);
    cloud->is_dense = false;
    return cloud;
  };
  const Cloud::Ptr source = view(0), target = view(0);
  // As a robot has it in another frame, whose origin is behind the body, from where it was not
  // seen.
  Eigen::Vector4f center;
  pcl::compute3DCentroid(*target, center);
  for (PointXYZRGBNormal& point : *target) point.z -= 2 * center.z();
  ASSERT_GT(source->height, 1);
  Registration registration;
  registration.setInputSource(source);
  registration.setInputTarget(target);
  Cloud output;
  registration.align(output);
  EXPECT_TRUE(registration.hasConverged()) << registration.getMessage();
  EXPECT_EQ(output.width, source->width);
  EXPECT_EQ(output.height, source->height);
  double miss = 0, seen = 0;
  for (std::size_t i = 0; i < source->size(); ++i) {
    ASSERT_EQ(std::isfinite(output[i].x), std::isfinite((*source)[i].x));
    if (!std::isfinite(output[i].x)) continue;
    miss += std::sqrt(squaredDistance(output[i], (*target)[i]));
    ++seen;
  }
  ASSERT_GT(seen, 1000);
  // One view to itself: to within the spacing of the rays.
  ASSERT_TRUE(registration.getResult().target_scan.has_value());
  EXPECT_LT(miss / seen, registration.getResult().target_scan->summary.spacing);
  EXPECT_LT(registration.getFitnessScore(),
            std::pow(registration.getResult().target_scan->summary.spacing, 2));
}

TEST(IsometricRegistration, undecidedDataGiveTheGuessWithoutConvergence) {
  const TriangleMesh target = test::body(0, 1000, 0, BodyKind::HUMAN).mesh;
  Registration registration = copyOfRegistered();
  registration.setTargetMesh(test::toColoredCloud(target), test::toPolygons(target.faces));
  Cloud output;
  registration.align(output);
  EXPECT_FALSE(registration.hasConverged());
  EXPECT_EQ(registration.getResult().status, Status::UNDECIDED);
  EXPECT_FALSE(registration.getMessage().empty());
  EXPECT_FALSE(registration.getCorrespondences()->empty());
  EXPECT_EQ(registration.getResult().deformed.rows(), output.size());
  EXPECT_FALSE(test::sameBytes(output, *registered().source));
  EXPECT_LT(registration.getFitnessScore(), NONE);
}

TEST(IsometricRegistration, aNewInputWithdrawsTheAnswer) {
  const Registered& r = registered();
  const auto empty = pcl::make_shared<Cloud>();
  const std::vector<std::function<void(Base&)>> changes{
      [&](Base& base) { base.setInputSource(r.source); },
      [&](Base& base) { base.setInputTarget(r.target); },
      [&](Base& base) { base.setInputSource(empty); },
      [&](Base& base) { base.setInputTarget(empty); },
      [&](Base& base) { base.setIndices(pcl::make_shared<pcl::Indices>(10, 0)); },
      [&](Base& base) {
        base.setIndices(pcl::IndicesConstPtr(pcl::make_shared<pcl::Indices>(10, 0)));
      },
      [&](Base& base) {
        const auto indices = pcl::make_shared<pcl::PointIndices>();
        indices->indices.assign(10, 0);
        base.setIndices(pcl::PointIndicesConstPtr(indices));
      },
      [&](Base& base) { base.setIndices(0, 0, 1, 10); }};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    Registration registration = copyOfRegistered();
    ASSERT_TRUE(registration.hasConverged());
    changes[k](registration);
    EXPECT_FALSE(registration.hasConverged()) << k;
    EXPECT_NE(registration.getMessage(), "") << k;
    EXPECT_TRUE(registration.getCorrespondences()->empty()) << k;
    EXPECT_TRUE(registration.getFinalTransformation().isIdentity()) << k;
    EXPECT_EQ(registration.getFitnessScore(), NONE) << k;
  }
}

TEST(IsometricRegistration, emptyInputsDoNotConverge) {
  const auto empty = pcl::make_shared<Cloud>();
  Registration no_source = copyOfRegistered(), no_target = copyOfRegistered();
  no_source.setInputSource(empty);
  no_target.setInputTarget(empty);
  Cloud output;
  for (Base* base : {static_cast<Base*>(&no_source), static_cast<Base*>(&no_target)}) {
    base->align(output);
    EXPECT_FALSE(base->hasConverged());
  }
  EXPECT_EQ(no_source.getMessage(), "source has no points");
  EXPECT_EQ(no_target.getMessage(), "target has no points");
  Registration nothing_set;
  nothing_set.align(output);
  EXPECT_FALSE(nothing_set.hasConverged());
  EXPECT_EQ(nothing_set.getFitnessScore(), NONE);
}

TEST(IsometricRegistration, anEmptySourceDropsTheIndicesThatWereSet) {
  const Registered& r = registered();
  Registration registration = copyOfRegistered();
  registration.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{5, 900, 7}));
  registration.setInputSource(pcl::make_shared<Cloud>());
  Cloud output = *r.source;
  registration.align(output);
  EXPECT_FALSE(registration.hasConverged());
  EXPECT_EQ(registration.getMessage(), "source has no points");
  EXPECT_TRUE(output.empty());
  // What comes next takes part as a whole.
  registration.setSourceMesh(r.source, test::toPolygons(r.source_body.mesh.faces));
  registration.align(output);
  EXPECT_TRUE(registration.hasConverged()) << registration.getMessage();
  EXPECT_TRUE(test::sameBytes(output, r.output));
}

TEST(IsometricRegistration, anEmptyTargetLeavesTheSourceAsItIs) {
  const Registered& r = registered();
  Registration registration = copyOfRegistered();
  registration.setInputTarget(pcl::make_shared<Cloud>());
  Registration copy = registration;
  for (Registration* each : {&registration, &copy}) {
    Cloud output;
    each->align(output);
    EXPECT_EQ(each->getMessage(), "target has no points");
    EXPECT_TRUE(test::sameBytes(output, *r.source));
    EXPECT_TRUE(each->getInputTarget()->empty());
  }
}

TEST(IsometricRegistration, callbackIsCalledAtOnceWithInputsThatExist) {
  const Registered& r = registered();
  using Sizes = std::vector<std::pair<std::size_t, std::size_t>>;
  Sizes sizes;  // of what it was called with
  std::function<Base::UpdateVisualizerCallbackSignature> none,
      callback = [&](const Cloud&cloud, const pcl::Indices&rows, const Cloud&target, const auto&) {
        sizes.emplace_back(cloud.size(), target.size());
        EXPECT_TRUE(rows.empty());
      };
  Registration registration;
  EXPECT_FALSE(registration.registerVisualizationCallback(none));
  EXPECT_TRUE(registration.registerVisualizationCallback(callback));
  registration.setInputSource(r.source);
  EXPECT_TRUE(registration.registerVisualizationCallback(callback));
  EXPECT_TRUE(sizes.empty()) << "called with an input that does not exist";
  registration.setInputTarget(pcl::make_shared<Cloud>());
  Base& base = registration;
  EXPECT_TRUE(base.registerVisualizationCallback(callback));
  registration.setInputTarget(r.target);
  EXPECT_TRUE(registration.registerVisualizationCallback(callback));
  EXPECT_EQ(sizes, (Sizes{{r.source->size(), 0}, {r.source->size(), r.target->size()}}));
}

/// The message of a registration that finds the data unusable, which leaves the source as it is.
std::string refusal(Registration& registration) {
  Cloud output, at_rest;
  EXPECT_NO_THROW(registration.align(output));
  EXPECT_FALSE(registration.hasConverged());
  EXPECT_TRUE(registration.getCorrespondences()->empty());
  EXPECT_TRUE(registration.getFinalTransformation().isIdentity());
  EXPECT_TRUE(registration.deform(output).empty());
  EXPECT_EQ(output.size(), registration.getIndices()->size());
  pcl::copyPointCloud(*registration.getInputSource(), *registration.getIndices(), at_rest);
  EXPECT_TRUE(test::sameBytes(output, at_rest));
  return registration.getMessage();
}

TEST(IsometricRegistration, badDataAreRefusedInALine) {
  const Registered& r = registered();
  Points line = Points::Zero(100, 3);
  for (int i = 0; i < 100; ++i) line(i, 0) = i;
  const Points missing = Points::Constant(100, 3, std::numeric_limits<double>::quiet_NaN());
  for (const Points& points :
       {line, missing, Points(line.topRows(1)), Points(Points::Zero(50, 3))}) {
    Registration registration = copyOfRegistered();
    registration.setInputSource(test::toCloud<PointXYZRGBNormal>(points));
    EXPECT_THAT(refusal(registration), StartsWith("source "));
    registration.setInputSource(r.source);
    registration.setInputTarget(test::toCloud<PointXYZRGBNormal>(points));
    EXPECT_THAT(refusal(registration), StartsWith("target "));
  }
  Registration registration = copyOfRegistered();
  registration.setIndices(pcl::make_shared<pcl::Indices>());
  EXPECT_EQ(refusal(registration), "source has no points");
  registration.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{0, 1}));
  EXPECT_THAT(refusal(registration), StartsWith("source "));
}

TEST(IsometricRegistration, printsNothingOfBadData) {
  const Registered& r = registered();
  const auto missing = test::toCloud<PointXYZRGBNormal>(
      Points::Constant(100, 3, std::numeric_limits<double>::quiet_NaN()));
  Registration registration = copyOfRegistered();
  Cloud output;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::vector<Cloud::ConstPtr> bad_clouds{pcl::make_shared<Cloud>(), missing};
  for (const Cloud::ConstPtr& bad : bad_clouds) {
    registration.setInputSource(bad);
    registration.align(output);
    registration.setInputSource(r.source);
    registration.setInputTarget(bad);
    registration.align(output);
    Registration(registration).align(output);
  }
  registration.setSourceMesh(pcl::PolygonMesh());
  registration.setTargetMesh(pcl::PolygonMesh());
  const std::string out = testing::internal::GetCapturedStdout(),
                    err = testing::internal::GetCapturedStderr();
  EXPECT_EQ(out + err, "");
  EXPECT_EQ(registration.getMessage(), "target has no points");
}

TEST(IsometricRegistration, theSurfaceAndWhereItWentAreHandedOut) {
  const Registered& r = registered();
  const DeformedSurface& surface = r.registration.getSurface();
  ASSERT_EQ(surface.rest.vertices.rows(), static_cast<Eigen::Index>(r.output.size()));
  Points at_rest(1, 3);
  at_rest << (*r.source)[17].x, (*r.source)[17].y, (*r.source)[17].z;
  const Eigen::RowVector3d place = applyDeformation(surface.rest, surface.deformed, at_rest).row(0);
  EXPECT_LT((place - r.registration.getResult().deformed.row(17)).norm(), 1e-6);
  EXPECT_EQ(Registration().getSurface().rest.vertices.rows(), 0);
}

TEST(IsometricRegistration, aVertexFarOutDoesNotTurnTheFinalTransformation) {
  const Registered& r = registered();
  const auto spiky = pcl::make_shared<Cloud>(*r.source);
  (*spiky)[100].x += 1e4f;
  Registration registration;
  registration.setSourceMesh(spiky, test::toPolygons(r.source_body.mesh.faces));
  registration.setTargetMesh(r.target, test::toPolygons(r.target_body.mesh.faces));
  Cloud output;
  registration.align(output);
  EXPECT_TRUE(registration.hasConverged());
  const Eigen::Matrix4f motion = registration.getFinalTransformation();
  Registration without = copyOfRegistered();
  EXPECT_LT((motion - without.getFinalTransformation()).cwiseAbs().maxCoeff(), r.edge);
  EXPECT_LT(squaredDistance(output[100], r.output[100]), 4 * r.edge * r.edge);
  const Points& denoised = registration.getResult().source_denoised;
  ASSERT_EQ(denoised.rows(), spiky->size());
  EXPECT_LT(denoised.cwiseAbs().maxCoeff(), 10) << "where it was registered from";
}

TEST(IsometricRegistration, polygonsThatDoNotFitAreRefusedInALine) {
  const Registered& r = registered();
  std::vector<pcl::Vertices> polygons = test::toPolygons(r.source_body.mesh.faces);
  polygons[7].vertices[1] = static_cast<int>(r.source->size());
  Registration registration = copyOfRegistered();
  registration.setSourceMesh(r.source, polygons);
  EXPECT_THAT(refusal(registration), StartsWith("source mesh names point "));
  polygons[7].vertices[1] = -1;
  registration.setSourceMesh(r.source, polygons);
  EXPECT_THAT(refusal(registration), StartsWith("source mesh names point -1 "));
  // Points that no triangle has all corners among are no surface, and not silently a cloud.
  registration.setSourceMesh(r.source, test::toPolygons(r.source_body.mesh.faces));
  registration.setIndices(pcl::make_shared<pcl::Indices>(200, 3));
  EXPECT_THAT(refusal(registration), StartsWith("source mesh has no "));
}

/// Polygons of a mesh: here and there all faces around a vertex but one in one, which is concave
/// and begun where a fan would cover what it leaves out.
std::vector<pcl::Vertices> withConcavePolygons(const TriangleMesh& mesh) {
  const std::vector<pcl::Vertices> triangles = test::toPolygons(mesh.faces);
  std::vector<pcl::Vertices> polygons;
  std::vector<char> used(triangles.size(), 0);
  const int n = static_cast<int>(mesh.vertices.rows());
  const VertexFaces around(mesh.faces, n);
  for (int v = 0; v < n; ++v) {
    const std::vector<int> own(around.begin(v), around.end(v));
    if (own.size() < 5 || std::any_of(own.begin(), own.end(), [&](int f) { return used[f] != 0; }))
      continue;
    std::map<int, int> next;
    for (int f : own)
      for (int k = 0; k < 3; ++k)
        if (mesh.faces(f, k) == v) next[mesh.faces(f, (k + 1) % 3)] = mesh.faces(f, (k + 2) % 3);
    pcl::Vertices polygon;
    int at = next.begin()->first;
    for (std::size_t k = 0; k < own.size(); ++k, at = next.at(at)) polygon.vertices.push_back(at);
    const int last = polygon.vertices.back();
    polygon.vertices.push_back(v);
    polygons.push_back(polygon);
    for (int f : own) used[f] = 1;
    pcl::Vertices left;
    left.vertices = {v, last, polygon.vertices.front()};
    polygons.push_back(left);
  }
  EXPECT_GT(polygons.size(), 200u);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (used[f] == 0) polygons.push_back(triangles[f]);
  return polygons;
}

TEST(IsometricRegistration, pclMeshesInDoublePrecisionAreTaken) {
  const Registered& r = registered();
  const auto inDouble = [](const Cloud& cloud, const TriangleMesh& mesh) {
    pcl::PolygonMesh polygons;
    pcl::PCLPointCloud2& data = polygons.cloud;
    data.height = 1;
    data.width = static_cast<std::uint32_t>(cloud.size());
    data.point_step = 3 * sizeof(double);
    data.row_step = data.width * data.point_step;
    for (int axis = 0; axis < 3; ++axis) {
      pcl::PCLPointField field;
      field.name = std::string(1, static_cast<char>('x' + axis));
      field.offset = axis * static_cast<std::uint32_t>(sizeof(double));
      field.datatype = pcl::PCLPointField::FLOAT64;
      field.count = axis == 0 ? 0 : 1;  // both stand for one
      data.fields.push_back(field);
    }
    for (const auto& point : cloud)
      for (const double coordinate : {point.x, point.y, point.z}) {
        const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&coordinate);
        data.data.insert(data.data.end(), bytes, bytes + sizeof coordinate);
      }
    polygons.polygons = test::toPolygons(mesh.faces);
    return polygons;
  };
  Registration registration;
  registration.setSourceMesh(inDouble(*r.source, r.source_body.mesh));
  registration.setTargetMesh(inDouble(*r.target, r.target_body.mesh));
  Cloud output;
  registration.align(output);
  EXPECT_EQ(registration.getResult().deformed, r.registration.getResult().deformed);
}

TEST(IsometricRegistration, optionsAndPclMeshesAreTaken) {
  const Registered& r = registered();
  const auto polygonMesh = [](const Cloud& cloud, const TriangleMesh& mesh) {
    pcl::PolygonMesh polygons;
    pcl::toPCLPointCloud2(cloud, polygons.cloud);
    polygons.polygons = withConcavePolygons(mesh);
    return polygons;
  };
  Registration registration;
  registration.setSourceMesh(polygonMesh(*r.source, r.source_body.mesh));
  registration.setTargetMesh(polygonMesh(*r.target, r.target_body.mesh));
  RegistrationOptions options;
  options.method = Method::PAPER;
  registration.setOptions(options);
  Cloud output;
  registration.align(output);
  const RegistrationResult direct = registerShapes(r.source_body.mesh, r.target_body.mesh, options);
  EXPECT_EQ(registration.getResult().hypotheses.size(), direct.hypotheses.size());
  EXPECT_EQ(registration.hasConverged(), direct.status == Status::REGISTERED);
  // Not quite flat, polygons are cut along other edges than the mesh was; fans would cover a sixth
  // more of each.
  EXPECT_NEAR(registration.getResult().source.area, direct.source.area, 0.05 * direct.source.area);
  EXPECT_EQ(output.size(), r.source->size());
}

}  // namespace
}  // namespace posture
