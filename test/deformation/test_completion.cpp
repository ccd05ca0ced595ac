// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/apply_deformation.h>
#include <posture/deformation/completion.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/nearest_on_faces.h>

#include <gtest/gtest.h>

#include "completion_terms.h"
#include "mean_value_term.h"
#include "support/motions.h"
#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

using test::moved;
using test::similarity;

TriangleMesh bumpy(int levels) {
  TriangleMesh mesh = test::sphere(levels);
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    const Eigen::RowVector3d p = mesh.vertices.row(v);
    mesh.vertices.row(v) *= 1 + 0.25 * std::sin(3 * p.x() + 1) * std::cos(2 * p.y() + p.z());
  }
  return mesh;
}

/// Every third vertex is matched with its own copy.
Correspondence someMatches(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  Correspondence matches;
  matches.on_target.resize(n);
  matches.confidence = Vector::Zero(n);
  for (int v = 0; v < n; v += 3) {
    matches.on_target[v].vertex = v;
    matches.confidence[v] = 1;
  }
  return matches;
}

Points noisy(const TriangleMesh& mesh, double edges) {
  return mesh.vertices + edges * meanEdgeLength(mesh) *
                             test::randomPoints(static_cast<int>(mesh.vertices.rows()), 8);
}

/// Largest distance from the true places, in edges.
double farthestOff(const Completion& completion, const TriangleMesh& truth) {
  return (completion.places - truth.vertices).rowwise().norm().maxCoeff() / meanEdgeLength(truth);
}

/// Squared distances from a surface, in its squared edges.
double meanSquaredGap(const Points& places, const TriangleMesh& surface) {
  double sum = 0;
  for (int v = 0; v < places.rows(); ++v) {
    NearestPlace nearest;
    for (int f = 0; f < surface.faces.rows(); ++f)
      lookInFace(surface.vertices, surface.faces, f, places.row(v), nearest);
    sum += nearest.squared;
  }
  return sum / (static_cast<double>(places.rows()) * std::pow(meanEdgeLength(surface), 2));
}

double meanStretch(const TriangleMesh& rest, const Points& places, double scale) {
  double sum = 0;
  const std::vector<Edge> edges = meshEdges(rest.faces);
  for (const Edge& e : edges)
    sum +=
        std::abs((places.row(e.first) - places.row(e.second)).norm() /
                     (scale * (rest.vertices.row(e.first) - rest.vertices.row(e.second)).norm()) -
                 1);
  return sum / static_cast<double>(edges.size());
}

void expectDerivatives(const ceres::CostFunction& term, std::uint64_t seed) {
  const int blocks = static_cast<int>(term.parameter_block_sizes().size());
  const int rows = term.num_residuals();
  Points at = test::randomPoints(blocks, seed);
  std::vector<double*> parameters;
  std::vector<double> storage(3 * blocks * rows);
  std::vector<double*> jacobians;
  for (int b = 0; b < blocks; ++b) {
    parameters.push_back(at.row(b).data());
    jacobians.push_back(storage.data() + 3 * b * rows);
  }
  Eigen::VectorXd value(rows), more(rows), less(rows);
  ASSERT_TRUE(term.Evaluate(parameters.data(), value.data(), jacobians.data()));
  constexpr double STEP = 1e-6;
  for (int b = 0; b < blocks; ++b)
    for (int axis = 0; axis < 3; ++axis) {
      const double here = at(b, axis);
      at(b, axis) = here + STEP;
      term.Evaluate(parameters.data(), more.data(), nullptr);
      at(b, axis) = here - STEP;
      term.Evaluate(parameters.data(), less.data(), nullptr);
      at(b, axis) = here;
      for (int r = 0; r < rows; ++r)
        EXPECT_NEAR((more[r] - less[r]) / (2 * STEP), jacobians[b][3 * r + axis], 1e-6);
    }
}

TEST(Completion, derivativesAreThoseOfDifferences) {
  const MeanValueEncoding encoding = encodeMeanValues(bumpy(1));
  for (std::uint64_t seed : {1, 2, 3}) {
    expectDerivatives(EdgeTerm(0.7, 1.3), seed);
    expectDerivatives(PlaneTerm({1, 2, 3}, Eigen::Vector3d(1, -2, 2) / 3, 0.4), seed);
    expectDerivatives(PlaceTerm({1, 2, 3}, 0.4), seed);
    expectDerivatives(MeanValueTerm(encoding, 5, 0.6), seed);
  }
}

TEST(Completion, findsARigidlyMovedCopy) {
  const TriangleMesh source = bumpy(3), target = moved(source, similarity());
  const Completion completion =
      completeDeformation(source, noisy(target, 0.3), someMatches(source), target);
  EXPECT_NEAR(completion.scale, 7, 0.5);
  EXPECT_LT(farthestOff(completion, target), 0.15);
  EXPECT_LT(meanSquaredGap(completion.places, target), 0.01);
}

TEST(Completion, staysWhereNothingIsLeftToDo) {
  const TriangleMesh source = bumpy(3), target = moved(source, similarity());
  const Completion completion =
      completeDeformation(source, target.vertices, someMatches(source), target);
  EXPECT_LT(farthestOff(completion, target), 1e-6);
}

TEST(Completion, doesNotFollowWrongMatches) {
  const TriangleMesh source = bumpy(3), target = moved(source, similarity());
  Correspondence matches = someMatches(source);
  const Correspondence right = matches;
  // One matched vertex of seven, and a whole patch, belong elsewhere.
  const int n = static_cast<int>(source.vertices.rows());
  for (int v = 0; v < n; v += 3)
    if (v % 7 == 0 || source.vertices(v, 0) > 0.8) matches.on_target[v] = right.on_target[300];
  const Completion completion = completeDeformation(source, noisy(target, 0.3), matches, target);
  EXPECT_LT(farthestOff(completion, target), 0.25);
}

TEST(Completion, isFreeOverAHoleAndFollowsItsOwnShape) {
  const TriangleMesh source = bumpy(3);
  TriangleMesh target = moved(source, similarity());
  const auto inHole = [&](int v) { return source.vertices.row(v).normalized().x() > 0.9; };
  Faces left(target.faces.rows(), 3);
  int count = 0;
  for (int f = 0; f < target.faces.rows(); ++f) {
    bool gone = false;
    for (int k = 0; k < 3; ++k) gone |= inHole(target.faces(f, k));
    if (!gone) left.row(count++) = target.faces.row(f);
  }
  Correspondence matches = someMatches(source);
  for (int v = 0; v < source.vertices.rows(); ++v)
    if (inHole(v)) {
      matches.on_target[v] = SurfacePoint();
      matches.confidence[v] = 0;
    }
  const TriangleMesh whole = target;
  target.faces = left.topRows(count);
  // The places in the hole are no help: the target's vertices there are gone.
  for (int v = 0; v < target.vertices.rows(); ++v)
    if (inHole(v)) target.vertices.row(v) = target.vertices.row(0);
  const Completion completion = completeDeformation(source, noisy(whole, 0.3), matches, target);
  EXPECT_LT(farthestOff(completion, whole), 0.6);
}

TEST(Completion, keepsLengthsWhereMatchesDoNot) {
  const TriangleMesh source = test::grid(30, 15, 2, 1);
  const TriangleMesh target = test::bentStrip(30, 15, 2, 1, 2);
  Correspondence matches = someMatches(source);
  const int n = static_cast<int>(source.vertices.rows());
  for (int v = 0; v + 3 < n; v += 3)  // off by a column, to and fro
    if (v % 2 == 0) matches.on_target[v].vertex = (matches.on_target[v].vertex + 1) % n;
  const Points start = noisy(target, 0.2);
  const Completion completion = completeDeformation(source, start, matches, target);
  EXPECT_LT(meanStretch(source, completion.places, 1), 0.2 * meanStretch(source, start, 1));
  EXPECT_LT(meanSquaredGap(completion.places, target), 0.01);
}

TEST(Completion, goesFromCoarseToFine) {
  const TriangleMesh source = bumpy(5), target = moved(source, similarity());
  const Completion completion =
      completeDeformation(source, noisy(target, 0.3), someMatches(source), target);
  EXPECT_LT(farthestOff(completion, target), 0.3);
}

TEST(Completion, refusesWhatDoesNotFit) {
  const TriangleMesh source = bumpy(1), target = moved(source, similarity());
  const Correspondence matches = someMatches(source);
  const Points& start = target.vertices;
  EXPECT_THROW(completeDeformation(source, start.topRows(3), matches, target),
               std::invalid_argument);
  EXPECT_THROW(completeDeformation(source, start, {}, target), std::invalid_argument);
  EXPECT_THROW(completeDeformation({source.vertices, Faces(0, 3)}, start, matches, target),
               std::invalid_argument);
  Points missing = start;
  missing(3, 1) = std::nan("");
  EXPECT_THROW(completeDeformation(source, missing, matches, target), std::invalid_argument);
  Correspondence off = matches;
  off.on_target[0].vertex = 10000;
  EXPECT_THROW(completeDeformation(source, start, off, target), std::invalid_argument);
}

}  // namespace
}  // namespace posture
