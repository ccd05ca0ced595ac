// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/reduce_mesh.h>
#include <posture/mesh/denoise.h>
#include <posture/mesh/edges.h>
#include <posture/pipeline/deformed_surface.h>
#include <posture/pipeline/register_shapes.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/bodies.h"
#include "support/shapes.h"
#include <algorithm>
#include <limits>
#include <omp.h>
#include <set>

namespace posture {
namespace {

const ArticulatedBody& body(int pose, int tessellation = 0) {
  return test::body(pose, 1500, tessellation);
}

/// Two poses of a body, registered as published.
struct Published {
  Published() {
    RegistrationOptions options;
    options.method = Method::PAPER;
    result = registerShapes(source.mesh, target.mesh, options);
  }

  ArticulatedBody source = body(0), target = body(2);
  RegistrationResult result;
};

const Published& published() {
  static const Published once;
  return once;
}

/// When a stage of an attempt took its turn; the end: never.
auto turnOf(const RegistrationResult& result,
            const std::string& attempt,
            const std::string& stage) {
  return std::find_if(result.timings.begin(), result.timings.end(), [&](const StageTiming& t) {
    return t.attempt == attempt && t.stage == stage;
  });
}

/// The vertices a correspondence maps to.
std::vector<int> verticesOf(const Correspondence& correspondence) {
  std::vector<int> vertices;
  for (const SurfacePoint& point : correspondence.on_target) vertices.push_back(point.vertex);
  return vertices;
}

/// Mean straight distance on the target between found and true places, in units of sqrt(area).
double meanError(const std::vector<int>& target_vertex,
                 const std::vector<VertexPair>& truth,
                 const RegistrationResult& result,
                 const TriangleMesh& target) {
  double sum = 0;
  int count = 0;
  for (const VertexPair& pair : truth) {
    const int found = target_vertex[pair.source];
    if (found < 0) continue;
    sum += (target.vertices.row(found) - target.vertices.row(pair.target)).norm();
    ++count;
  }
  return count == 0 ? 1 : sum / count / std::sqrt(result.target.area);
}

TEST(RegisterShapes, oneOfItsCandidatesMatchesTwoPosesOfABody) {
  const auto& [source, target, result] = published();
  ASSERT_EQ(result.hypotheses.size(), 8);
  const std::vector<VertexPair> truth = groundTruth(source, target);
  double best = 1;
  for (const HypothesisSummary& h : result.hypotheses)
    best = std::min(best, meanError(h.target_vertex, truth, result, target.mesh));
  // What the method reaches on articulated animals, in hundredths of sqrt(area).
  EXPECT_LT(best, 0.06);
}

TEST(RegisterShapes, theLeastDeformedCandidateWinsAsPublished) {
  const RegistrationResult& result = published().result;
  const HypothesisSummary& chosen = result.hypotheses[result.chosen];
  for (const HypothesisSummary& h : result.hypotheses) {
    EXPECT_EQ(h.energy, std::max(h.source_energy, h.target_energy));
    EXPECT_LE(h.kernel_samples, h.matched_samples);
    EXPECT_LE(chosen.energy, h.energy);
  }
  EXPECT_EQ(verticesOf(result.correspondence), chosen.target_vertex);
}

/// A quadruped in two poses, each with a tessellation of its own; its mirror image keeps all
/// distances.
class RegisteredQuadruped : public testing::Test {
 protected:
  static const ArticulatedBody source_, target_;

  static RegistrationResult registered() {
    RegistrationOptions options;
    options.both_ways = true;
    return registerShapes(source_.mesh, target_.mesh, options);
  }

  static const RegistrationResult& result() {
    static const RegistrationResult once = registered();
    return once;
  }
};

const ArticulatedBody RegisteredQuadruped::source_ = body(0);
const ArticulatedBody RegisteredQuadruped::target_ = body(2, 1);

TEST_F(RegisteredQuadruped, isOnTheRightSideAndExactToAnEdge) {
  EXPECT_EQ(result().status, Status::REGISTERED) << result().message;
  EXPECT_EQ(result().source_denoised.rows() + result().target_denoised.rows(), 0) << "clean meshes";
  for (const char* stage : {"tips", "letting go"})
    EXPECT_EQ(turnOf(result(), "", stage), result().timings.end()) << "nothing is missing";
  const std::vector<VertexPair> truth = groundTruth(source_, target_);
  const double edge = result().target.mean_edge_length / std::sqrt(result().target.area);
  EXPECT_LT(meanError(verticesOf(result().correspondence), truth, result(), target_.mesh), edge);
}

TEST_F(RegisteredQuadruped, liesWhollyOnTheTargetAndKeepsItsLengths) {
  const TriangleMesh &source = source_.mesh, &target = target_.mesh;
  double stretch = 0;
  for (int f = 0; f < source.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = source.faces(f, k), b = source.faces(f, (k + 1) % 3);
      const double before = (source.vertices.row(a) - source.vertices.row(b)).norm();
      const double after = (result().deformed.row(a) - result().deformed.row(b)).norm();
      stretch += std::abs(after / (result().scale * before) - 1);
    }
  EXPECT_LT(stretch / static_cast<double>(source.faces.size()), 0.05);
  std::vector<double> off;
  for (int v = 0; v < source.vertices.rows(); ++v)
    off.push_back(
        (target.vertices.rowwise() - result().deformed.row(v)).rowwise().norm().minCoeff());
  std::nth_element(off.begin(), off.begin() + off.size() / 2, off.end());
  EXPECT_LT(off[off.size() / 2], 0.5 * result().target.mean_edge_length);
}

TEST_F(RegisteredQuadruped, theWayBackAgrees) {
  ASSERT_TRUE(result().back.has_value());
  EXPECT_EQ(result().back->correspondence.on_target.size(), target_.mesh.vertices.rows());
  EXPECT_LT(result().back->mean_miss * std::sqrt(result().source.area),
            result().source.mean_edge_length);
}

TEST_F(RegisteredQuadruped, isTheSameWithAnyNumberOfThreads) {
  const int threads = omp_get_max_threads();
  const RegistrationResult& one = result();
  omp_set_num_threads(threads == 1 ? 3 : 1);
  const RegistrationResult other = registered();
  omp_set_num_threads(threads);
  EXPECT_EQ(one.deformed, other.deformed);
  EXPECT_EQ(one.correspondence.confidence, other.correspondence.confidence);
  EXPECT_EQ(verticesOf(one.correspondence), verticesOf(other.correspondence));
  EXPECT_EQ(verticesOf(one.back->correspondence), verticesOf(other.back->correspondence));
  EXPECT_EQ(one.score, other.score);
  ASSERT_EQ(one.alternatives.size(), other.alternatives.size());
  for (std::size_t k = 0; k < one.alternatives.size(); ++k)
    EXPECT_EQ(one.alternatives[k].score, other.alternatives[k].score);
}

/// Registered with all answers taken to full precision, and what its observer was told.
struct Observed {
  Observed() {
    RegistrationOptions options;
    options.refine_alternatives = true;
    result = registerShapes(body(0).mesh, body(1).mesh, options, [this](const StageEvent& event) {
      EXPECT_GE(event.progress, progress);
      progress = event.progress;
      if (!event.pictures) {
        stages.emplace_back(event.stage);
        return;
      }
      for (const StagePicture& picture : event.pictures()) {
        EXPECT_TRUE(pictures.insert(picture.name).second) << picture.name << " twice";
        EXPECT_GT(picture.mesh.vertices.rows(), 0) << picture.name;
      }
    });
  }

  std::vector<std::string> stages;
  std::set<std::string> pictures;
  double progress = 0;
  RegistrationResult result;
};

const Observed& observed() {
  static const Observed once;
  return once;
}

TEST(RegisterShapes, theBestAnswerIsChosenAndTheOthersDiffer) {
  const RegistrationResult& result = observed().result;
  ASSERT_EQ(result.chosen, 0);
  ASSERT_GT(result.alternatives.size(), 1);
  EXPECT_EQ(result.alternatives[0].gap, 0);
  for (std::size_t k = 1; k < result.alternatives.size(); ++k) {
    const AlternativeSummary& other = result.alternatives[k];
    EXPECT_GE(other.score, result.alternatives[k - 1].score);
    EXPECT_GT(other.gap, 0.05);
    EXPECT_GT(other.orientation, 0);
    EXPECT_EQ(other.correspondence.on_target.size(), body(0).mesh.vertices.rows());
  }
}

TEST(RegisterShapes, tellsItsObserverOfEveryStageInOrder) {
  const std::vector<StageTiming>& timings = observed().result.timings;
  ASSERT_EQ(observed().stages.size(), timings.size());
  for (std::size_t i = 0; i < timings.size(); ++i)
    EXPECT_EQ(observed().stages[i], timings[i].stage);
  EXPECT_LE(observed().progress, 1);
  EXPECT_EQ(observed().pictures.count("source-canonical-form"), 1);
}

TEST(RegisterShapes, aShapeGoesToItselfMovedTurnedAndScaled) {
  const TriangleMesh source = body(1).mesh;
  TriangleMesh target = source;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  target.vertices =
      (25.4 * source.vertices * turn.transpose()).rowwise() + Eigen::RowVector3d(9, 8, 7);
  const RegistrationResult result = registerShapes(source, target);
  EXPECT_EQ(result.status, Status::REGISTERED);
  EXPECT_NEAR(result.scale, 25.4, 0.01);
  std::vector<VertexPair> identity;
  for (int v = 0; v < source.vertices.rows(); ++v) identity.push_back({v, v});
  EXPECT_LT(meanError(verticesOf(result.correspondence), identity, result, target), 0.002);
}

TEST(RegisterShapes, everyInputVertexHasARow) {
  TriangleMesh source = body(0).mesh;
  const TriangleMesh eye = test::sphere(0);
  const int n = static_cast<int>(source.vertices.rows());
  source.vertices.conservativeResize(n + 13, 3);
  source.vertices.middleRows(n, 12) = (0.01 * eye.vertices).rowwise() + source.vertices.row(5);
  source.vertices.row(n + 12) = source.vertices.row(7);
  source.faces.conservativeResize(source.faces.rows() + eye.faces.rows(), 3);
  source.faces.bottomRows(eye.faces.rows()) = eye.faces.array() + n;
  const TriangleMesh target = body(1).mesh;
  const RegistrationResult result = registerShapes(source, target);
  ASSERT_EQ(result.correspondence.on_target.size(), n + 13);
  ASSERT_EQ(result.correspondence.confidence.size(), n + 13);
  ASSERT_EQ(result.deformed.rows(), n + 13);
  EXPECT_TRUE(result.deformed.allFinite());
  EXPECT_EQ(result.source.cleaning.loose_vertices, 12);
  for (std::size_t v = 0; v < result.correspondence.on_target.size(); ++v) {
    const SurfacePoint& point = result.correspondence.on_target[v];
    ASSERT_LT(point.vertex, target.vertices.rows());
    EXPECT_EQ(point.vertex < 0, result.correspondence.confidence[v] == 0);
    if (point.vertex < 0) continue;
    Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k)
      place += point.barycentric[k] * target.vertices.row(target.faces(point.face, k));
    // The nearest vertex is one of the face's, or not far from it.
    EXPECT_LT((place - target.vertices.row(point.vertex)).norm(),
              2 * result.target.mean_edge_length);
  }
  // A repeated vertex goes where the first one goes.
  EXPECT_EQ(result.correspondence.on_target[n + 12].vertex,
            result.correspondence.on_target[7].vertex);
}

TEST(RegisterShapes, noiseAndVerticesFarFromTheirNeighboursDoNoHarm) {
  const ArticulatedBody source = body(0), target = body(1, 1);
  const auto spoilt = [](TriangleMesh mesh, double length) {
    const Points off = test::randomPoints(static_cast<int>(mesh.vertices.rows()), 3);
    mesh.vertices += 0.4 * meanEdgeLength(mesh) * off;
    for (int v = 0; v < mesh.vertices.rows(); v += 50) mesh.vertices.row(v) += length * off.row(v);
    return mesh;
  };
  const RegistrationResult result =
      registerShapes(spoilt(source.mesh, 1e6), spoilt(target.mesh, 10));
  EXPECT_EQ(result.status, Status::REGISTERED);
  for (const ShapeSummary& side : {result.source, result.target}) {
    EXPECT_GE(side.denoising.spikes, 0.019 * side.vertices);
    EXPECT_GE(side.denoising.smoothing_rounds, 1);
  }
  const double error = meanError(
      verticesOf(result.correspondence), groundTruth(source, target), result, target.mesh);
  EXPECT_LT(error, 0.03);
  EXPECT_LT(result.deformed.cwiseAbs().maxCoeff(), 2 * target.mesh.vertices.cwiseAbs().maxCoeff());

  // It takes the places the vertices had along with it, from where it was denoised to.
  Shape given;
  given.cloud.points = spoilt(source.mesh, 1e6).vertices;
  given.faces = source.mesh.faces;
  TriangleMesh denoised{given.cloud.points, given.faces};
  denoise(denoised);
  EXPECT_EQ(result.source_denoised, denoised.vertices);
  EXPECT_EQ(result.target_denoised.rows(), target.mesh.vertices.rows());
  PointCloud clean;
  clean.points = source.mesh.vertices;
  const Points carried = applyDeformation(deformedSurface(given, result), clean).points;
  const Vector off = (carried - result.deformed).rowwise().norm();
  EXPECT_LT(off.mean(), 0.5 * result.target.mean_edge_length);
  EXPECT_LT(off.maxCoeff(), 3 * result.target.mean_edge_length);
}

TEST(RegisterShapes, holesAreClosedForTheSearchAndHaveNoRow) {
  BodyOptions options;
  options.vertices = 1500;
  options.holes = 8;
  options.hole_radius = 0.05;
  const ArticulatedBody source = makeBody(options);
  options.pose = 2;
  options.tessellation = 1;
  const ArticulatedBody target = makeBody(options);
  RegistrationOptions both;
  both.both_ways = true;
  const RegistrationResult result = registerShapes(source.mesh, target.mesh, both);
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  EXPECT_GE(result.source.patched_holes, 4);
  EXPECT_GE(result.target.patched_holes, 4);
  // The surfaces as they are come second and lead to the same answer: there they end.
  const auto begins = [&](const std::string& attempt, const std::string& stage) {
    return turnOf(result, attempt, stage);
  };
  EXPECT_LT(begins("patched", "refinement"), begins("", "spectrum"));
  EXPECT_NE(begins("patched", "letting go"), result.timings.end());
  EXPECT_EQ(begins("", "letting go"), result.timings.end());
  EXPECT_EQ(begins("", "turning"), result.timings.end());
  EXPECT_EQ(begins("", "growing anew"), result.timings.end());
  EXPECT_NE(begins("", "bending"), result.timings.end());
  EXPECT_EQ(begins("", "refinement"), result.timings.end());
  EXPECT_EQ(result.source.vertices, source.mesh.vertices.rows());
  EXPECT_EQ(result.target.faces, target.mesh.faces.rows());
  EXPECT_GT(result.source.boundary_edges, 0);
  EXPECT_EQ(result.deformed.rows(), source.mesh.vertices.rows());
  ASSERT_TRUE(result.back);
  const auto expectOn =
      [](const Correspondence& map, const TriangleMesh& from, const TriangleMesh& to) {
        ASSERT_EQ(map.on_target.size(), from.vertices.rows());
        ASSERT_EQ(map.confidence.size(), from.vertices.rows());
        for (std::size_t v = 0; v < map.on_target.size(); ++v) {
          const SurfacePoint& place = map.on_target[v];
          EXPECT_LT(place.vertex, to.vertices.rows());
          EXPECT_LT(place.face, to.faces.rows());
          EXPECT_EQ(place.vertex < 0, map.confidence[static_cast<int>(v)] == 0);
          if (place.vertex < 0) continue;
          EXPECT_NEAR(place.barycentric.sum(), 1, 1e-9);
        }
      };
  expectOn(result.correspondence, source.mesh, target.mesh);
  expectOn(result.back->correspondence, target.mesh, source.mesh);
  for (const AlternativeSummary& alternative : result.alternatives) {
    EXPECT_EQ(alternative.target_vertex.size(), source.mesh.vertices.rows());
    for (int v : alternative.target_vertex) EXPECT_LT(v, target.mesh.vertices.rows());
  }
  EXPECT_LT(
      meanError(
          verticesOf(result.correspondence), groundTruth(source, target), result, target.mesh),
      0.02);
}

TEST(RegisterShapes, aCoarseSourceGetsMoreVerticesWhileMapsAreSought) {
  const ArticulatedBody fine = body(0), target = body(2);
  const ReducedMesh reduced = reduceMesh(fine.mesh, 350);
  const auto n = reduced.mesh.vertices.rows();
  // A face beside the body, a point in no face, and a vertex given again.
  TriangleMesh given = reduced.mesh;
  given.vertices.conservativeResize(n + 5, 3);
  const Eigen::RowVector3d beside = given.vertices.row(3) * 1.05;
  given.vertices.bottomRows(5) << beside, beside + Eigen::RowVector3d(0.01, 0, 0),
      beside + Eigen::RowVector3d(0, 0.01, 0), given.vertices.row(20) * 1.02, given.vertices.row(7);
  given.faces.conservativeResize(given.faces.rows() + 1, 3);
  given.faces.bottomRows(1) << static_cast<int>(n), static_cast<int>(n) + 1,
      static_cast<int>(n) + 2;

  RegistrationOptions all;
  all.both_ways = true;
  const RegistrationResult result = registerShapes(given, target.mesh, all);
  ASSERT_EQ(result.status, Status::REGISTERED) << result.message;
  std::vector<int> number(fine.mesh.vertices.rows(), -1);
  for (int v = 0; v < n; ++v) number[reduced.vertex[v]] = v;
  std::vector<VertexPair> truth;
  for (const VertexPair& pair : groundTruth(fine, target))
    if (number[pair.source] >= 0) truth.push_back({number[pair.source], pair.target});
  const double error = meanError(verticesOf(result.correspondence), truth, result, target.mesh);
  EXPECT_LT(error, 0.0042);  // 0.0033, and 0.0053 on its own vertices alone

  // Everything is told of what was given.
  EXPECT_EQ(result.source.vertices, n + 5);
  EXPECT_EQ(result.source.clean_vertices, n);
  EXPECT_EQ(result.source.added_vertices, 6000 - n);
  EXPECT_EQ(result.target.added_vertices, 0);
  EXPECT_EQ(result.correspondence.on_target.size(), n + 5);
  EXPECT_EQ(result.correspondence.confidence.size(), n + 5);
  EXPECT_EQ(result.correspondence.on_target[n + 4].vertex,
            result.correspondence.on_target[7].vertex);
  ASSERT_EQ(result.deformed.rows(), n + 5);
  EXPECT_TRUE(result.deformed.allFinite());
  for (const AlternativeSummary& alternative : result.alternatives) {
    EXPECT_EQ(alternative.target_vertex.size(), n + 5);
    for (int v : alternative.target_vertex) EXPECT_LT(v, target.mesh.vertices.rows());
  }
  ASSERT_TRUE(result.back);
  const std::vector<SurfacePoint>& back = result.back->correspondence.on_target;
  ASSERT_EQ(back.size(), target.mesh.vertices.rows());
  std::vector<double> off;
  std::set<int> faces;
  for (std::size_t t = 0; t < back.size(); ++t) {
    if (back[t].vertex < 0) continue;
    ASSERT_LT(back[t].vertex, n);
    ASSERT_GE(back[t].face, 0);
    ASSERT_LT(back[t].face, reduced.mesh.faces.rows());
    EXPECT_GE(back[t].barycentric.minCoeff(), 0);
    EXPECT_NEAR(back[t].barycentric.sum(), 1, 1e-9);
    faces.insert(back[t].face);
    // The place in the face, taken to the target with its corners, is where it came from.
    Eigen::RowVector3d place = Eigen::RowVector3d::Zero(), there = place;
    for (int k = 0; k < 3; ++k) {
      place += back[t].barycentric[k] * given.vertices.row(given.faces(back[t].face, k));
      there += back[t].barycentric[k] * result.deformed.row(given.faces(back[t].face, k));
    }
    EXPECT_LT((place - given.vertices.row(back[t].vertex)).norm(),
              2 * result.source.mean_edge_length);
    off.push_back((there - target.mesh.vertices.row(static_cast<int>(t))).norm());
  }
  EXPECT_GT(off.size(), 0.95 * static_cast<double>(back.size()));
  EXPECT_GT(faces.size(), 0.9 * static_cast<double>(reduced.mesh.faces.rows()));
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 0.13 * result.source.mean_edge_length);
  EXPECT_LT(result.back->mean_miss * std::sqrt(result.source.area),
            0.2 * result.source.mean_edge_length);
}

TEST(RegisterShapes, refusesWhatIsNoMesh) {
  TriangleMesh no_corner = test::sphere(2), not_finite = test::sphere(2);
  no_corner.faces(0, 2) = static_cast<int>(no_corner.vertices.rows());
  not_finite.vertices(0, 1) = std::numeric_limits<double>::quiet_NaN();
  for (const TriangleMesh& bad : {no_corner, not_finite}) {
    for (const bool is_source : {true, false}) {
      const TriangleMesh good = test::sphere(2);
      try {
        registerShapes(is_source ? bad : good, is_source ? good : bad);
        FAIL() << "nothing thrown";
      } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()).rfind(is_source ? "source mesh: " : "target mesh: ", 0),
                  0U)
            << error.what();
      }
    }
  }
}

TEST(RegisterShapes, namesTheSideThatCannotBeUsed) {
  const TriangleMesh sphere = test::sphere(2);
  TriangleMesh cloud = sphere, triangle;
  cloud.faces.resize(0, 3);
  triangle.vertices = Points::Identity(3, 3);
  triangle.faces.resize(1, 3);
  triangle.faces << 0, 1, 2;
  for (const TriangleMesh& bad : {cloud, triangle}) {
    try {
      registerShapes(sphere, bad);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("target ", 0), 0) << error.what();
    }
    EXPECT_THROW(registerShapes(bad, sphere), InputError);
  }
}

TEST(RegisterShapes, refusesWhatIsTooCoarseToTellAShape) {
  // Two ends of a band of 40 vertices: the rest lies within a mean edge of them.
  const TriangleMesh band = test::grid(19, 1, 0.1, 10);
  try {
    registerShapes(band, band);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("source has only"), std::string::npos) << error.what();
  }
}

TEST(RegisterShapes, doesNotPretendToKnowUnrelatedShapes) {
  const RegistrationResult result = registerShapes(test::sphere(4), body(0).mesh);
  EXPECT_EQ(result.status, Status::UNDECIDED);
  EXPECT_FALSE(result.message.empty());
  EXPECT_NE(turnOf(result, "", "tips"), result.timings.end()) << "no map convinces";
}

}  // namespace
}  // namespace posture
