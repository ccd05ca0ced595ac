// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/median.h>
#include <posture/core/parallel.h>
#include <posture/core/unions.h>
#include <posture/geodesic/landmarks.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/corners.h>
#include <posture/mesh/deformation_scale.h>
#include <posture/mesh/edges.h>
#include <posture/segmentation/rigid_segments.h>

#include "moments.h"
#include "otsu.h"
#include "pieces.h"
#include "robust_factors.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>

namespace posture {
namespace {

using Eigen::Vector3d;

constexpr int PATCHES = 200;             // some ten a limb: a joint is several patches long
constexpr int COMPARABLE = 150;          // clusters large enough for their turns to mean something
constexpr double ROUNDING_TURN = 0.005;  // a quarter of a degree: nothing bends at all
constexpr double ROUNDING_COST = 1e-14;  // a unit of area, what sums of squares of order 1 leave

/// Lengths in square roots of the area, around the centroid.
Points normalized(const Points& places, double unit) {
  return (places.rowwise() - places.colwise().mean()) / unit;
}

/// A set of faces and how it moves.
struct Cluster {
  std::vector<Moments> moments;  // one a pose
  double area = 0, misfit = 0;   // of all poses
  std::set<int> adjacent;
  int version = 0;
};

double misfitOf(const std::vector<Moments>& moments) {
  double sum = 0;
  for (const Moments& m : moments) sum += m.misfit();
  return sum;
}

/// What it costs to move two clusters as one.
double mergingCost(const Cluster& a, const Cluster& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.moments.size(); ++k) {
    Moments both = a.moments[k];
    both.add(b.moments[k]);
    sum += both.misfit();
  }
  return std::max(0.0, sum - a.misfit - b.misfit);
}

class Clustering {
 public:
  Clustering(const TriangleMesh& rest, const std::vector<Points>& poses, const Vector& areas)
      : clusters_(rest.faces.rows()), into_(rest.faces.rows()) {
    std::iota(into_.begin(), into_.end(), 0);
    const Faces across = facesAcross(rest.faces);
    const int faces = static_cast<int>(clusters_.size());
    Unions islands(faces);
    for (int f = 0; f < faces; ++f)
      for (int g : across.row(f))
        if (g >= 0) islands.join(f, g);
    merges_left_ = faces - islands.count();
    for (int f = 0; f < rest.faces.rows(); ++f) {
      Cluster& cluster = clusters_[f];
      cluster.moments.resize(poses.size());
      for (int c = 0; c < 3; ++c) {
        const int v = rest.faces(f, c);
        for (std::size_t k = 0; k < poses.size(); ++k)
          cluster.moments[k].add(rest.vertices.row(v), poses[k].row(v), areas[f] / 3);
        if (across(f, c) >= 0) cluster.adjacent.insert(across(f, c));
      }
      cluster.area = areas[f];
      cluster.misfit = misfitOf(cluster.moments);
    }
  }

  /// On a mesh in islands, that many on one of them and single clusters on the others.
  void mergeDownTo(int count) {
    std::priority_queue<Candidate> queue;
    const auto push = [&](int a, int b, double cost) {
      const Cluster &one = clusters_[a], &other = clusters_[b];
      const double rounding = ROUNDING_COST * (one.area + other.area);
      queue.push({std::max(cost, rounding), cost, a, b, one.version, other.version});
    };
    std::vector<std::pair<int, int>> pairs;
    for (int f = 0; f < static_cast<int>(clusters_.size()); ++f)
      for (int g : clusters_[f].adjacent)
        if (f < g) pairs.emplace_back(f, g);
    std::vector<double> costs(pairs.size());
    forEach(static_cast<int>(pairs.size()), [&](int i) {
      costs[i] = mergingCost(clusters_[pairs[i].first], clusters_[pairs[i].second]);
    });
    for (std::size_t i = 0; i < pairs.size(); ++i) push(pairs[i].first, pairs[i].second, costs[i]);
    while (merges_left_ >= count && !queue.empty()) {
      const Candidate best = queue.top();
      queue.pop();
      if (clusters_[best.a].version != best.version_a ||
          clusters_[best.b].version != best.version_b)
        continue;
      merge(best.a, best.b, best.cost);
      for (int g : clusters_[best.a].adjacent)
        push(best.a, g, mergingCost(clusters_[best.a], clusters_[g]));
    }
  }

  /// Of each face.
  std::vector<int> labels() {
    std::vector<int> label(clusters_.size());
    for (std::size_t f = 0; f < label.size(); ++f) label[f] = find(static_cast<int>(f));
    return label;
  }

 private:
  struct Candidate {
    double rank = 0;  // the cost, but no less than rounding makes: the smaller clusters come first
    double cost = 0;
    int a = -1, b = -1, version_a = 0, version_b = 0;

    bool operator<(const Candidate& other) const {  // the least comes first
      return std::tie(rank, a, b) > std::tie(other.rank, other.a, other.b);
    }
  };

  int find(int f) {
    while (into_[f] != f) f = into_[f] = into_[into_[f]];
    return f;
  }

  void merge(int a, int b, double cost) {
    Cluster &kept = clusters_[a], &gone = clusters_[b];
    kept.area += gone.area;
    for (std::size_t k = 0; k < kept.moments.size(); ++k) kept.moments[k].add(gone.moments[k]);
    kept.misfit += gone.misfit + cost;
    for (int g : gone.adjacent) {
      clusters_[g].adjacent.erase(b);
      if (g == a) continue;
      clusters_[g].adjacent.insert(a);
      kept.adjacent.insert(g);
    }
    gone.adjacent.clear();
    ++kept.version;
    gone.version = -1;
    into_[b] = a;
    --merges_left_;
  }

  std::vector<Cluster> clusters_;
  std::vector<int> into_;
  int merges_left_ = 0;  // until no two clusters have an edge in common
};

/// Each face goes with the sample nearest to one of its corners. Each piece of the mesh takes one.
std::vector<int> patchesOf(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const std::vector<int> face = faceOfEachVertex(mesh.faces, n);
  const auto loose = static_cast<int>(std::count(face.begin(), face.end(), -1));
  Unions pieces(n);
  for (const auto& f : mesh.faces.rowwise())
    for (int v : f) pieces.join(f[0], v);
  const Landmarks samples =
      voronoiSamples(mesh, FastMarching(mesh), PATCHES + pieces.count() - loose - 1, 0);
  std::vector<int> patch(mesh.faces.rows());
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const int sample = samples.nearest[mesh.faces(f, 0)];
    patch[f] = sample;  // -1: what no sample reaches
  }
  return patch;
}

/// The part with most area around each vertex.
std::vector<int> vertexLabels(const TriangleMesh& mesh,
                              const Vector& areas,
                              const std::vector<int>& face_label) {
  std::vector<std::map<int, double>> share(mesh.vertices.rows());
  for (int f = 0; f < mesh.faces.rows(); ++f)
    for (int c = 0; c < 3; ++c) share[mesh.faces(f, c)][face_label[f]] += areas[f];
  std::vector<int> label(share.size(), -1);
  for (std::size_t v = 0; v < share.size(); ++v) {
    double most = -1;
    for (const auto& [part, area] : share[v])
      if (area > most) {
        most = area;
        label[v] = part;
      }
  }
  return label;
}

/// The rigid motion of a set of faces, those counting little that bend.
Eigen::Isometry3d robustMotion(const TriangleMesh& rest,
                               const Points& pose,
                               const Vector& areas,
                               const std::vector<int>& faces) {
  constexpr int ROUNDS = 10;
  std::vector<double> factor(faces.size(), 1.0), misfit(faces.size());
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for (int round = 0; round < ROUNDS; ++round) {
    Moments moments;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const int v = rest.faces(faces[i], c);
        moments.add(rest.vertices.row(v), pose.row(v), factor[i] * areas[faces[i]]);
      }
    motion = moments.motion();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      misfit[i] = 0;
      for (int c = 0; c < 3; ++c) {
        const int v = rest.faces(faces[i], c);
        misfit[i] +=
            (motion * Vector3d(rest.vertices.row(v)) - Vector3d(pose.row(v))).squaredNorm();
      }
    }
    factor = robustFactors(misfit);
  }
  return motion;
}

/// The same for one that may have slid along the surface.
Eigen::Isometry3d robustMotion(const PosedBody& body,
                               std::size_t pose,
                               const std::vector<int>& faces) {
  constexpr int ROUNDS = 30;
  const PosedSurface& surface = body.poses[pose];
  double area = 0;
  for (int f : faces) area += body.areas[f];
  return slideOnto(surface,
                   body.rest.vertices,
                   verticesOf(body, faces),
                   robustMotion(body.rest, surface.places(), body.areas, faces),
                   {weightAlong(area), ROUNDS, true})
      .motion;
}

/// What separates turns at joints from others.
double leastTurn(std::vector<double> turns) {
  for (double& turn : turns) turn = std::cbrt(turn);
  return 0.7 * std::pow(otsuThreshold(std::move(turns)), 3);
}

}  // namespace

RigidSegments segmentRigidParts(const TriangleMesh& rest, const std::vector<Points>& poses) {
  require(!poses.empty(), "segmentRigidParts: no pose");
  for (const Points& pose : poses) {
    require(pose.rows() == rest.vertices.rows(), "segmentRigidParts: one place a vertex");
    require(pose.allFinite(), "segmentRigidParts: places that are no numbers");
  }
  const double unit = rootArea(rest);
  require(unit > 0, "segmentRigidParts: a mesh without area");

  RigidSegments segments;
  const TriangleMesh shape{normalized(rest.vertices, unit), rest.faces};
  std::vector<Points> shapes;
  for (const Points& pose : poses) {
    segments.scale.push_back(scaleWithoutNoise(rest, pose));
    shapes.push_back(normalized(pose, unit * segments.scale.back()));
  }
  // Faces without area still have neighbours to go with.
  constexpr double LEAST_AREA = 1e-12;
  const Vector areas = faceAreas(shape).cwiseMax(LEAST_AREA);

  const PosedBody body(shape, shapes, areas);
  std::vector<double> turns = Pieces(body, patchesOf(shape)).turns();
  segments.least_turn = std::max(ROUNDING_TURN, leastTurn(std::move(turns)));
  Clustering clustering(shape, shapes, areas);
  clustering.mergeDownTo(COMPARABLE);
  Pieces pieces(body, clustering.labels());
  pieces.mergeBelow(segments.least_turn);

  segments.face_label = pieces.labels();
  segments.count = 1 + *std::max_element(segments.face_label.begin(), segments.face_label.end());
  segments.label = vertexLabels(shape, areas, segments.face_label);
  std::vector<std::vector<int>> faces(segments.count);
  for (int f = 0; f < rest.faces.rows(); ++f) faces[segments.face_label[f]].push_back(f);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double scale = segments.scale[k];
    const Vector3d from = scale * rest.vertices.colwise().mean().transpose(),
                   to = poses[k].colwise().mean();
    segments.motion.emplace_back(faces.size());
    parallelFor(segments.count, [&](int part) {
      Eigen::Isometry3d& motion = segments.motion.back()[part];
      motion = robustMotion(body, k, faces[part]);
      motion.translation() = scale * unit * motion.translation() + to - motion.linear() * from;
    });
  }
  return segments;
}

}  // namespace posture
