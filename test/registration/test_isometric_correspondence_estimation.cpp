// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/registration/isometric_correspondence_estimation.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/registration/correspondence_rejection_one_to_one.h>
#include <pcl/registration/correspondence_rejection_sample_consensus.h>
#include <pcl/registration/transformation_estimation_svd.h>

#include "registration/pcl_bodies.h"
#include "support/bodies.h"
#include "support/motions.h"
#include "support/shapes.h"
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace posture {
namespace {

using pcl::PointXYZ;
using Cloud = pcl::PointCloud<PointXYZ>;
using Estimation = IsometricCorrespondenceEstimation<PointXYZ, PointXYZ>;

Eigen::Affine3d motion() {
  return Eigen::Translation3d(0.5, 1, -2) *
         Eigen::AngleAxisd(2.5, Eigen::Vector3d(3, 1, 2).normalized());
}

/// Two poses, the second moved away.
struct Bodies {
  ArticulatedBody source_body = test::body(0, 1000), target_body = test::body(1, 1000, 1);
  Cloud::Ptr source = test::toCloud<PointXYZ>(source_body.mesh.vertices);
  Cloud::Ptr target = test::toCloud<PointXYZ>(test::moved(target_body.mesh.vertices, motion()));
  Estimation estimation;
  pcl::Correspondences matches;

  Bodies() {
    estimation.setSourceMesh(source, test::toPolygons(source_body.mesh.faces));
    estimation.setTargetMesh(target, test::toPolygons(target_body.mesh.faces));
    estimation.determineCorrespondences(matches);
  }
  double edge() const { return meanEdgeLength(target_body.mesh); }
};

const Bodies& bodies() {
  static const Bodies once;
  return once;
}

/// For what is the same by either method, in a fraction of the time.
RegistrationOptions published() {
  RegistrationOptions options;
  options.method = Method::PAPER;
  return options;
}

double squaredDistance(const pcl::Correspondence& match) {
  return ((*bodies().source)[match.index_query].getVector3fMap() -
          (*bodies().target)[match.index_match].getVector3fMap())
      .cast<double>()
      .squaredNorm();
}

TEST(IsometricCorrespondenceEstimation, matchesAreTheTrueOnesHoweverTheCloudsLie) {
  const Bodies& b = bodies();
  EXPECT_EQ(b.estimation.getResult().status, Status::REGISTERED) << b.estimation.getMessage();
  ASSERT_GT(b.matches.size(), 0.9 * static_cast<double>(b.source->size()));
  std::map<int, int> truth;
  for (const VertexPair& pair : groundTruth(b.source_body, b.target_body))
    truth[pair.source] = pair.target;
  double miss = 0;
  for (const pcl::Correspondence& match : b.matches) {
    miss += ((*b.target)[match.index_match].getVector3fMap() -
             (*b.target)[truth.at(match.index_query)].getVector3fMap())
                .norm();
    EXPECT_NEAR(match.distance, squaredDistance(match), 1e-4);
  }
  EXPECT_LT(miss / static_cast<double>(b.matches.size()), b.edge());
}

TEST(IsometricCorrespondenceEstimation, farPairsAreLeftOut) {
  Estimation estimation = bodies().estimation;
  double sum = 0;
  for (const pcl::Correspondence& match : bodies().matches) sum += std::sqrt(match.distance);
  const double limit = sum / static_cast<double>(bodies().matches.size());
  pcl::Correspondences near;
  estimation.determineCorrespondences(near, limit);
  std::size_t expected = 0;
  for (const pcl::Correspondence& match : bodies().matches)
    if (match.distance <= limit * limit) ++expected;
  EXPECT_EQ(near.size(), expected);
  EXPECT_LT(near.size(), bodies().matches.size());
  EXPECT_GT(near.size(), 0);
  for (const pcl::Correspondence& match : near) EXPECT_LE(match.distance, limit * limit);
}

TEST(IsometricCorrespondenceEstimation, whatAnObserverThrowsLeavesItToBeDoneAgain) {
  struct Cancelled : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  Estimation estimation = bodies().estimation;
  estimation.setOptions(published());
  bool ends = true;
  int stages = 0;
  estimation.setObserver([&](const StageEvent&) {
    if (ends) throw Cancelled("enough");
    ++stages;
  });
  pcl::Correspondences matches = bodies().matches;
  EXPECT_THROW(estimation.determineCorrespondences(matches), Cancelled);
  EXPECT_TRUE(estimation.getResult().correspondence.on_target.empty());
  ends = false;
  estimation.determineCorrespondences(matches);
  EXPECT_GT(stages, 3);
  EXPECT_FALSE(matches.empty());
  EXPECT_EQ(estimation.getResult().correspondence.on_target.size(), bodies().source->size());
}

TEST(IsometricCorrespondenceEstimation, reciprocalMatchesAreOneToOne) {
  Estimation estimation = bodies().estimation;
  pcl::Correspondences both_ways;
  estimation.determineReciprocalCorrespondences(both_ways);
  EXPECT_GT(both_ways.size(), 0.2 * static_cast<double>(bodies().matches.size()));
  std::map<int, int> match_of;
  for (const pcl::Correspondence& match : bodies().matches)
    match_of[match.index_query] = match.index_match;
  std::set<int> targets;
  for (const pcl::Correspondence& match : both_ways) {
    EXPECT_EQ(match_of.at(match.index_query), match.index_match);
    EXPECT_TRUE(targets.insert(match.index_match).second);
  }
}

TEST(IsometricCorrespondenceEstimation, pclFindsTheMotionOfOnePartFromTheMatches) {
  const Bodies& b = bodies();
  const auto one_to_one = [&] {
    pcl::registration::CorrespondenceRejectorOneToOne rejector;
    pcl::Correspondences kept;
    rejector.getRemainingCorrespondences(b.matches, kept);
    return kept;
  }();
  EXPECT_LT(one_to_one.size(), b.matches.size());
  // Sample consensus keeps the part that moves as one; the pose leaves the trunk where it was.
  pcl::registration::CorrespondenceRejectorSampleConsensus<PointXYZ> consensus;
  consensus.setInputSource(b.source);
  consensus.setInputTarget(b.target);
  consensus.setInlierThreshold(b.edge());
  consensus.setMaximumIterations(1000);
  pcl::Correspondences rigid;
  consensus.getRemainingCorrespondences(one_to_one, rigid);
  ASSERT_GT(rigid.size(), one_to_one.size() / 4);
  EXPECT_LT(rigid.size(), one_to_one.size());
  Eigen::Matrix4f found;
  pcl::registration::TransformationEstimationSVD<PointXYZ, PointXYZ>().estimateRigidTransformation(
      *b.source, *b.target, rigid, found);
  for (const pcl::Correspondence& match : rigid) {
    const Eigen::Vector4f place = found * (*b.source)[match.index_query].getVector4fMap();
    EXPECT_LT((place.head<3>() - (*b.target)[match.index_match].getVector3fMap()).norm(),
              3 * b.edge());
  }
  const Eigen::Matrix3d turn = found.topLeftCorner<3, 3>().cast<double>();
  EXPECT_LT(Eigen::AngleAxisd(turn.transpose() * motion().rotation()).angle(), 0.3);
}

TEST(IsometricCorrespondenceEstimation, registersAnewOnlyWhenSomethingChanged) {
  Estimation estimation = bodies().estimation;
  const auto* before = estimation.getResult().correspondence.on_target.data();
  pcl::Correspondences matches;
  estimation.determineCorrespondences(matches);
  EXPECT_EQ(matches.size(), bodies().matches.size());
  EXPECT_EQ(estimation.getResult().correspondence.on_target.data(), before);

  const auto empty = pcl::make_shared<pcl::Indices>();
  estimation.setIndicesSource(empty);
  estimation.determineCorrespondences(matches);
  EXPECT_TRUE(matches.empty());
  EXPECT_EQ(estimation.getMessage(), "source has no points");
}

TEST(IsometricCorrespondenceEstimation, aCloudThatHasLostPointsIsRegisteredAnew) {
  Estimation estimation;
  estimation.setOptions(published());
  const auto target = pcl::make_shared<Cloud>(*bodies().target);
  estimation.setInputSource(bodies().source);
  estimation.setInputTarget(target);
  pcl::Correspondences matches;
  estimation.determineCorrespondences(matches);
  ASSERT_FALSE(matches.empty());
  target->resize(target->size() / 2);
  estimation.determineCorrespondences(matches);
  EXPECT_GT(estimation.getResult().target.vertices, 0);
  EXPECT_LE(estimation.getResult().target.vertices, static_cast<int>(target->size()));
  for (const pcl::Correspondence& match : matches)
    ASSERT_LT(match.index_match, static_cast<int>(target->size()));
}

TEST(IsometricCorrespondenceEstimation, aCloudSetThroughTheBaseIsRegistered) {
  Estimation estimation;
  estimation.setInputTarget(bodies().target);
  estimation.setOptions(published());
  pcl::Correspondences matches, reversed_matches;
  estimation.setInputSource(bodies().source);
  estimation.determineCorrespondences(matches);
  ASSERT_FALSE(matches.empty());
  const auto reversed = pcl::make_shared<Cloud>(*bodies().source);
  std::reverse(reversed->begin(), reversed->end());
  estimation.setInputCloud(reversed);
  estimation.determineCorrespondences(reversed_matches);
  std::map<int, int> match_of;
  for (const pcl::Correspondence& match : matches) match_of[match.index_query] = match.index_match;
  int alike = 0;
  const int last = static_cast<int>(reversed->size()) - 1;
  for (const pcl::Correspondence& match : reversed_matches) {
    const auto known = match_of.find(last - match.index_query);
    alike += known != match_of.end() && known->second == match.index_match;
  }
  EXPECT_GT(alike, 0.9 * static_cast<double>(matches.size()));
}

TEST(IsometricCorrespondenceEstimation, indicesThatNameNoPointAreRefusedInALine) {
  for (const int wrong : {-1, 100'000'000}) {
    const auto indices = pcl::make_shared<pcl::Indices>(pcl::Indices{0, wrong, 2});
    pcl::Correspondences matches = bodies().matches;
    Estimation source = bodies().estimation, target = bodies().estimation;
    source.setIndicesSource(indices);
    source.determineCorrespondences(matches);
    EXPECT_TRUE(matches.empty());
    EXPECT_EQ(source.getMessage(),
              "source index " + std::to_string(wrong) + " names no point of " +
                  std::to_string(bodies().source->size()));
    matches = bodies().matches;
    target.setIndicesTarget(indices);
    target.setOptions(published());
    target.determineCorrespondences(matches);
    EXPECT_TRUE(matches.empty());
    EXPECT_EQ(target.getMessage().rfind("target index ", 0), 0U) << target.getMessage();
  }
}

TEST(IsometricCorrespondenceEstimation, emptyInputsHaveNoMatches) {
  const auto empty = pcl::make_shared<Cloud>();
  const auto refusal = [](Estimation& estimation) {
    for (const bool reciprocal : {false, true}) {
      pcl::Correspondences matches = bodies().matches;
      if (reciprocal)
        estimation.determineReciprocalCorrespondences(matches);
      else
        estimation.determineCorrespondences(matches);
      EXPECT_TRUE(matches.empty());
    }
    EXPECT_TRUE(estimation.getResult().correspondence.on_target.empty());
    return estimation.getMessage();
  };
  Estimation no_source = bodies().estimation, no_target = bodies().estimation, nothing_set;
  no_source.setIndicesSource(pcl::make_shared<pcl::Indices>(pcl::Indices{5, 900, 7}));
  no_source.setInputSource(empty);
  no_target.setIndicesTarget(pcl::make_shared<pcl::Indices>(pcl::Indices{5, 900, 7}));
  no_target.setTargetMesh(empty, {});
  for (const Estimation* each : {&no_source, &no_target})
    EXPECT_TRUE(each->getResult().correspondence.on_target.empty()) << "of inputs that are gone";
  EXPECT_EQ(refusal(no_source), "source has no points");
  EXPECT_EQ(refusal(no_target), "target has no points");
  EXPECT_EQ(refusal(nothing_set), "an input was not set");
}

TEST(IsometricCorrespondenceEstimation, copiesAndClonesAreOnTheirOwn) {
  Estimation original = bodies().estimation;
  const Estimation::Base::Ptr clone = original.clone();
  auto line = pcl::make_shared<Cloud>();
  for (int i = 0; i < 100; ++i) line->push_back({static_cast<float>(i), 0, 0});
  original.setInputTarget(line);
  pcl::Correspondences of_original, of_clone;
  original.determineCorrespondences(of_original);
  clone->determineCorrespondences(of_clone);
  EXPECT_TRUE(of_original.empty());
  EXPECT_EQ(original.getMessage().substr(0, 7), "target ");
  EXPECT_EQ(of_clone.size(), bodies().matches.size());
}

TEST(IsometricCorrespondenceEstimation, takesIndicesOfBothSides) {
  const Bodies& b = bodies();
  Estimation estimation;
  estimation.setInputSource(b.source);
  estimation.setInputTarget(b.target);
  // The front halves, backwards.
  const auto is_front = [](const ArticulatedBody& body, int i) {
    return body.rest_position(i, 1) > body.rest_position.col(1).mean();
  };
  const auto front = [&](const ArticulatedBody& body) {
    auto indices = pcl::make_shared<pcl::Indices>();
    for (int i = static_cast<int>(body.rest_position.rows()) - 1; i >= 0; --i)
      if (is_front(body, i)) indices->push_back(i);
    return indices;
  };
  const auto source_indices = front(b.source_body), target_indices = front(b.target_body);
  estimation.setIndicesSource(source_indices);
  estimation.setIndicesTarget(target_indices);
  estimation.setOptions(published());
  pcl::Correspondences matches;
  estimation.determineCorrespondences(matches);
  ASSERT_FALSE(matches.empty()) << estimation.getMessage();
  for (const pcl::Correspondence& match : matches) {
    EXPECT_TRUE(is_front(b.source_body, match.index_query));
    EXPECT_TRUE(is_front(b.target_body, match.index_match));
  }
  const std::vector<SurfacePoint>& places = estimation.getResult().correspondence.on_target;
  ASSERT_EQ(places.size(), source_indices->size());
  for (const pcl::Correspondence& match : matches) {
    const auto row = std::find(source_indices->begin(), source_indices->end(), match.index_query) -
                     source_indices->begin();
    EXPECT_EQ((*target_indices)[places[row].vertex], match.index_match);
  }
}

TEST(IsometricCorrespondenceEstimation, normalsSayWhatIsOutside) {
  const auto to_blob = [](const Points& normals) {
    pcl::PointCloud<pcl::Normal> cloud;
    for (const auto& n : normals.rowwise())
      cloud.push_back(
          {static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())});
    auto blob = pcl::make_shared<pcl::PCLPointCloud2>();
    pcl::toPCLPointCloud2(cloud, *blob);
    return blob;
  };
  // Open sheets, whose outside is a matter of choice: opposite ones here.
  const TriangleMesh flat = test::grid(40, 20, 2, 1), bent = test::bentStrip(40, 20, 2, 1, 1);
  Estimation estimation;
  estimation.setInputSource(test::toCloud<PointXYZ>(flat.vertices));
  estimation.setInputTarget(test::toCloud<PointXYZ>(bent.vertices));
  estimation.setOptions(published());
  EXPECT_FALSE(estimation.requiresSourceNormals());
  EXPECT_FALSE(estimation.requiresTargetNormals());
  for (const double side : {1, -1}) {
    estimation.setSourceNormals(to_blob(side * vertexNormals(flat)));
    estimation.setTargetNormals(to_blob(-side * vertexNormals(bent)));
    pcl::Correspondences matches;
    estimation.determineCorrespondences(matches);
    const RegistrationResult& result = estimation.getResult();
    ASSERT_TRUE(result.source_scan && result.target_scan) << estimation.getMessage();
    EXPECT_GT(side * vertexNormals(result.source_scan->mesh).col(2).mean(), 0.5);
    EXPECT_LT(side * vertexNormals(result.target_scan->mesh).col(2).mean(), -0.5);
  }
}

}  // namespace
}  // namespace posture
