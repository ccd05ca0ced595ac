// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/median.h>
#include <posture/core/parallel.h>
#include <posture/deformation/apply_deformation.h>
#include <posture/deformation/completion.h>
#include <posture/deformation/mean_value_encoding.h>
#include <posture/deformation/reduce_mesh.h>
#include <posture/mesh/deformation_scale.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/position_of.h>

#include <ceres/ceres.h>

#include "completion_terms.h"
#include "mean_value_term.h"
#include "target_surface.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

using Eigen::Vector3d;

// Weights of the energies. A surface that changes its lengths by a tenth costs as much as one a
// third of an edge off the target: bodies are less isometric than their surface is known exactly.
// Matches are good to about an edge, most of it along the surface, and count less still.
constexpr double ISOMETRY = 1, ENCODING = 1, SURFACE = 0.1, MATCHES = 0.06;
/// How much stiffer the encoding is at first, so that folds of the start open.
constexpr double FIRST_STIFFNESS = 10;

constexpr int COARSE = 5000;  // vertices
/// How often places are looked for; fewer after a coarse level.
constexpr int FULL_ROUNDS = 6, FINE_ROUNDS = 2;
/// Of the solver after each.
constexpr int STEPS = 2;
/// Of the trust region, which is kept from round to round. The solver's own start is the largest,
/// and most of its first steps are found too long.
constexpr double FIRST_RADIUS = 10, LARGEST_RADIUS = 1e4;

/// What is known of one vertex.
struct Match {
  int vertex = -1;  // of the target; -1: nothing
  Vector3d place = Vector3d::Zero();
  double confidence = 0;
  bool pulls = false;
};

/// The source at one resolution, on its way to the target. Lengths in mean edges of the target.
class Level {
 public:
  Level(const TriangleMesh& rest,
        Points places,
        std::vector<Match> matches,
        const TargetSurface& target)
      : rest_(rest),
        neighbors_(rest.faces, static_cast<int>(rest.vertices.rows())),
        encoding_(encodeMeanValues(rest, false)),
        places_(std::move(places)),
        matches_(std::move(matches)),
        target_(target),
        on_target_(places_.rows()) {
    // Edges far below the mean are not worth their stiffness.
    constexpr double SHORTEST = 0.1;
    const double shortest = SHORTEST * meanEdgeLength(rest);
    for (const Edge& e : meshEdges(rest.faces)) {
      const double rest_length = length(rest.vertices, e);
      if (!(rest_length > 0)) continue;
      stiff_.push_back({e, rest_length, std::min(1.0, rest_length / shortest)});
    }
    for (int v = 0; v < encoding_.vertexCount(); ++v)
      radii_.push_back(std::max(shortest, radius(v)));
    for (int v = 0; v < places_.rows(); ++v)
      on_target_[v].at.vertex =
          matches_[v].vertex >= 0 ? matches_[v].vertex : target_.nearestVertex(places_.row(v));
  }

  void settle(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      const double left = std::max(0.0, 1 - 2.0 * round / rounds);
      stiffness_ = 1 + left * (FIRST_STIFFNESS - 1);
      findPlaces();
      weighMatches();
      minimise();
    }
  }

  const Points& places() const { return places_; }

 private:
  struct StiffEdge {
    Edge edge;
    double length;  // at rest
    double weight;
  };

  static double length(const Points& at, const Edge& e) {
    return (at.row(e.first) - at.row(e.second)).norm();
  }

  /// Of the polygon that vertex is told by, at rest.
  double radius(int v) const {
    const int begin = encoding_.first[v], end = encoding_.first[v + 1];
    Eigen::RowVector3d centroid = Eigen::RowVector3d::Zero();
    for (int i = begin; i < end; ++i)
      centroid += rest_.vertices.row(encoding_.corner[i]) / (end - begin);
    double sum = 0;
    for (int i = begin; i < end; ++i)
      sum += (rest_.vertices.row(encoding_.corner[i]) - centroid).squaredNorm() / (end - begin);
    return std::sqrt(sum);
  }

  void findPlaces() {
    const Points normals = vertexNormals({places_, rest_.faces});
    std::vector<SurfacePlace> found(on_target_.size());
    forEach(static_cast<int>(found.size()), [&](int v) {
      const Vector3d place = places_.row(v);
      std::vector<int> starts{on_target_[v].at.vertex, target_.nearestVertex(place)};
      for (const int* w = neighbors_.begin(v); w != neighbors_.end(v); ++w)
        starts.push_back(on_target_[*w].at.vertex);
      found[v] = target_.find(place, normals.row(v), starts);
    });
    on_target_ = std::move(found);
  }

  /// How far each match is believed: little where it is farther off than most.
  void weighMatches() {
    std::vector<double> off;
    for (int v = 0; v < places_.rows(); ++v)
      if (matches_[v].pulls) off.push_back((matches_[v].place - Vector3d(places_.row(v))).norm());
    const double typical = off.empty() ? 1 : std::max(1.0, 2 * median(std::move(off)));
    belief_.assign(places_.rows(), 0);
    for (int v = 0; v < places_.rows(); ++v) {
      if (!matches_[v].pulls) continue;
      const double ratio = (matches_[v].place - Vector3d(places_.row(v))).norm() / typical;
      belief_[v] = matches_[v].confidence / std::pow(1 + ratio * ratio, 2);
    }
  }

  void minimise() {
    ceres::Problem problem;
    const auto at = [&](int v) { return places_.row(v).data(); };
    for (const StiffEdge& e : stiff_)
      problem.AddResidualBlock(new EdgeTerm(e.length, std::sqrt(ISOMETRY) * e.weight),
                               nullptr,
                               at(e.edge.first),
                               at(e.edge.second));
    for (int v = 0; v < places_.rows(); ++v) {
      auto* shape = new MeanValueTerm(encoding_, v, std::sqrt(ENCODING * stiffness_) / radii_[v]);
      problem.AddResidualBlock(shape, nullptr, shape->parametersIn(places_));
      const SurfacePlace& on = on_target_[v];
      if (!on.beyond_rim) {
        // What is several edges off the surface has none there.
        constexpr double FAR = 3;
        const double ratio = (on.place - Vector3d(places_.row(v))).norm() / FAR;
        problem.AddResidualBlock(
            new PlaneTerm(on.place, on.normal, std::sqrt(SURFACE) / (1 + ratio * ratio)),
            nullptr,
            at(v));
      }
      if (belief_[v] > 0)
        problem.AddResidualBlock(
            new PlaceTerm(matches_[v].place, std::sqrt(MATCHES * belief_[v])), nullptr, at(v));
    }
    ceres::Solver::Options options;
    // Conjugate gradients, to a tenth of the residual: what is left is of low frequency, and right
    // from the start or from the coarse level. A factorisation takes twenty times as long.
    options.linear_solver_type = ceres::CGNR;
    options.preconditioner_type = ceres::JACOBI;
    options.eta = 0.1;
    options.max_linear_solver_iterations = 200;
    options.max_num_iterations = STEPS;
    options.initial_trust_region_radius = radius_;
    options.max_trust_region_radius = LARGEST_RADIUS;
    options.function_tolerance = 1e-4;
    options.num_threads = 1;  // sums in one order
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (summary.iterations.empty()) return;  // refused: the places stay as they are
    radius_ = summary.iterations.back().trust_region_radius;
  }

  const TriangleMesh& rest_;
  std::vector<StiffEdge> stiff_;
  VertexNeighbors neighbors_;
  MeanValueEncoding encoding_;
  std::vector<double> radii_;
  Points places_;
  std::vector<Match> matches_;
  std::vector<double> belief_;
  const TargetSurface& target_;
  std::vector<SurfacePlace> on_target_;
  double stiffness_ = 1, radius_ = FIRST_RADIUS;
};

void check(const TriangleMesh& source,
           const Points& start,
           const Correspondence& matches,
           const TriangleMesh& target) {
  const auto n = source.vertices.rows();
  require(source.faces.rows() > 0 && target.faces.rows() > 0,
          "completeDeformation: a mesh without faces");
  require(start.rows() == n && static_cast<Eigen::Index>(matches.on_target.size()) == n &&
              matches.confidence.size() == n,
          "completeDeformation: one start and one match a vertex");
  require(source.vertices.allFinite() && start.allFinite() && target.vertices.allFinite(),
          "completeDeformation: a place that is not finite");
  for (const SurfacePoint& at : matches.on_target)
    require(at.vertex < target.vertices.rows() && at.face < target.faces.rows(),
            "completeDeformation: a match off the target");
}

}  // namespace

Completion completeDeformation(const TriangleMesh& source,
                               const Points& start,
                               const Correspondence& matches,
                               const TriangleMesh& target) {
  check(source, start, matches, target);
  const double unit = meanEdgeLength(target);
  const Eigen::RowVector3d centre = target.vertices.colwise().mean();
  Completion completion;
  completion.scale = scaleWithoutNoise(source, start);
  const auto inUnits = [&](const Points& places) -> Points {
    return (places.rowwise() - centre) / unit;
  };
  const TriangleMesh onto{inUnits(target.vertices), target.faces};
  const TriangleMesh rest{completion.scale / unit * source.vertices, source.faces};
  const TargetSurface surface(onto);
  const std::vector<char> at_boundary =
      boundaryVertices(source.faces, static_cast<int>(source.vertices.rows()));
  std::vector<Match> known(matches.on_target.size());
  for (std::size_t v = 0; v < known.size(); ++v) {
    const SurfacePoint& at = matches.on_target[v];
    if (at.vertex < 0) continue;
    known[v] = {at.vertex,
                positionOf(onto, at).transpose(),
                matches.confidence[static_cast<int>(v)],
                at_boundary[v] != 0 || !surface.onBoundary(at.vertex)};
  }

  Points places = inUnits(start);
  const bool coarse_first = rest.vertices.rows() > COARSE * 3 / 2;
  if (coarse_first) {
    const ReducedMesh reduced = reduceMesh(rest, COARSE);
    Points reduced_places(reduced.vertex.size(), 3);
    std::vector<Match> reduced_known;
    for (std::size_t i = 0; i < reduced.vertex.size(); ++i) {
      reduced_places.row(i) = places.row(reduced.vertex[i]);
      reduced_known.push_back(known[reduced.vertex[i]]);
    }
    Level level(reduced.mesh, std::move(reduced_places), std::move(reduced_known), surface);
    level.settle(FULL_ROUNDS);
    places = applyDeformation(reduced.mesh, level.places(), rest.vertices);
  }
  Level level(rest, std::move(places), std::move(known), surface);
  level.settle(coarse_first ? FINE_ROUNDS : FULL_ROUNDS);
  completion.places = (unit * level.places()).rowwise() + centre;
  return completion;
}

}  // namespace posture
