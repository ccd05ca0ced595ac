// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/geodesic/landmarks.h>
#include <posture/mesh/edges.h>
#include <posture/segmentation/rigid_segments.h>

#include <boost/pending/disjoint_sets.hpp>

#include "joint.h"
#include "moments.h"
#include "otsu.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace posture {
namespace {

using Eigen::Vector3d;

constexpr int PATCHES = 200;             // some ten a limb: a joint is several patches long
constexpr int COMPARABLE = 150;          // clusters large enough for their turns to mean something
constexpr double LEAST_SHARE = 0.005;    // of the area
constexpr double ROUNDING_TURN = 0.005;  // a quarter of a degree: nothing bends at all
constexpr double ROUNDING_COST = 1e-14;  // a unit of area, what sums of squares of order 1 leave

/// Lengths in square roots of the area, around the centroid.
Points normalized(const Points& places, double unit) {
  return (places.rowwise() - places.colwise().mean()) / unit;
}

/// Sets of things that are joined, directly or by others; `join` is given a function of two.
template <class Join>
int countJoined(int things, const Join& join) {
  std::vector<int> rank(things), parent(things);
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  for (int i = 0; i < things; ++i) sets.make_set(i);
  int count = things;
  join([&](int a, int b) {
    if (sets.find_set(a) == sets.find_set(b)) return;
    sets.union_set(a, b);
    --count;
  });
  return count;
}

/// A set of faces and how it moves.
struct Cluster {
  Mass mass;                     // at rest
  std::vector<Moments> moments;  // one a pose
  double misfit = 0;             // of all poses
  int faces = 1;
  std::map<int, Border> adjacent;
  int version = 0;

  double area() const { return mass.area(); }
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

/// The turn of two clusters against each other, in radians: root mean square over the poses.
double turnOf(const Cluster& a, const Cluster& b, const Border& border, double cost) {
  return turnOf(a.mass, b.mass, border.middle(), cost / static_cast<double>(a.moments.size()));
}

/// Whether the cost of moving two clusters as one is what noise makes. Twelve numbers fitted to
/// noise save as much misfit as a handful of faces have; choosing the clusters for little misfit
/// makes that some ten times more.
bool isNoise(const Cluster& a, const Cluster& b, double cost) {
  constexpr double FACES = 100;
  return cost < FACES * (a.misfit + b.misfit) / (a.faces + b.faces);
}

class Clustering {
 public:
  Clustering(const TriangleMesh& rest, const std::vector<Points>& poses, const Vector& areas)
      : clusters_(rest.faces.rows()), into_(rest.faces.rows()) {
    std::iota(into_.begin(), into_.end(), 0);
    const Faces across = facesAcross(rest.faces);
    const int islands = countJoined(static_cast<int>(clusters_.size()), [&](const auto& join) {
      for (int f = 0; f < across.rows(); ++f)
        for (int g : across.row(f))
          if (g >= 0) join(f, g);
    });
    merges_left_ = static_cast<int>(clusters_.size()) - islands;
    for (int f = 0; f < rest.faces.rows(); ++f) {
      Cluster& cluster = clusters_[f];
      cluster.moments.resize(poses.size());
      for (int c = 0; c < 3; ++c) {
        const Vector3d from = rest.vertices.row(rest.faces(f, c)),
                       to = rest.vertices.row(rest.faces(f, (c + 1) % 3));
        cluster.mass.add(from, areas[f] / 3);
        for (std::size_t k = 0; k < poses.size(); ++k)
          cluster.moments[k].add(from, poses[k].row(rest.faces(f, c)), areas[f] / 3);
        if (across(f, c) >= 0) cluster.adjacent[across(f, c)].add(from, to);
      }
      cluster.misfit = misfitOf(cluster.moments);
      total_area_ += areas[f];
    }
  }

  /// The turns between adjacent patches, each a set of faces.
  std::vector<double> turnsBetween(const std::vector<int>& patch_of_face, int patches) const {
    std::vector<Cluster> patch(patches);
    std::map<std::pair<int, int>, Border> borders;
    for (std::size_t f = 0; f < clusters_.size(); ++f) {
      Cluster& own = patch[patch_of_face[f]];
      own.mass.add(clusters_[f].mass);
      if (own.moments.empty()) own.moments.resize(clusters_[f].moments.size());
      for (std::size_t k = 0; k < own.moments.size(); ++k)
        own.moments[k].add(clusters_[f].moments[k]);
      for (const auto& [g, border] : clusters_[f].adjacent)
        if (patch_of_face[g] > patch_of_face[f])
          borders[{patch_of_face[f], patch_of_face[g]}].add(border);
    }
    for (Cluster& p : patch) p.misfit = misfitOf(p.moments);
    std::vector<double> turns;
    for (const auto& [pair, border] : borders) {
      const Cluster &a = patch[pair.first], &b = patch[pair.second];
      turns.push_back(turnOf(a, b, border, mergingCost(a, b)));
    }
    return turns;
  }

  /// On a mesh in islands, that many on one of them and single clusters on the others.
  void mergeDownTo(int count) {
    std::priority_queue<Candidate> queue;
    const auto push = [&](int a, int b) {
      const Cluster &one = clusters_[a], &other = clusters_[b];
      const double cost = mergingCost(one, other);
      const double rounding = ROUNDING_COST * (one.area() + other.area());
      queue.push({std::max(cost, rounding), cost, a, b, one.version, other.version});
    };
    for (int f = 0; f < static_cast<int>(clusters_.size()); ++f)
      for (const auto& [g, border] : clusters_[f].adjacent)
        if (f < g) push(f, g);
    while (merges_left_ >= count && !queue.empty()) {
      const Candidate best = queue.top();
      queue.pop();
      if (clusters_[best.a].version != best.version_a ||
          clusters_[best.b].version != best.version_b)
        continue;
      merge(best.a, best.b, best.cost);
      for (const auto& [g, border] : clusters_[best.a].adjacent) push(best.a, g);
    }
  }

  void mergeBelow(double turn) {
    for (;;) {
      Candidate best;
      for (int a = 0; a < static_cast<int>(clusters_.size()); ++a) {
        if (into_[a] != a) continue;
        for (const auto& [b, border] : clusters_[a].adjacent) {
          if (b < a) continue;
          const double cost = mergingCost(clusters_[a], clusters_[b]);
          const bool small =
              std::min(clusters_[a].area(), clusters_[b].area()) < LEAST_SHARE * total_area_;
          if ((small || turnOf(clusters_[a], clusters_[b], border, cost) < turn ||
               isNoise(clusters_[a], clusters_[b], cost)) &&
              (best.a < 0 || cost < best.cost))
            best = {cost, cost, a, b, 0, 0};
        }
      }
      if (best.a < 0) return;
      merge(best.a, best.b, best.cost);
    }
  }

  /// Numbers of the clusters of all faces, that of the largest area first.
  std::vector<int> labels() {
    std::vector<int> order;
    for (int a = 0; a < static_cast<int>(clusters_.size()); ++a)
      if (find(a) == a) order.push_back(a);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return clusters_[a].area() > clusters_[b].area();
    });
    std::vector<int> number(clusters_.size()), label(clusters_.size());
    for (std::size_t i = 0; i < order.size(); ++i) number[order[i]] = static_cast<int>(i);
    for (std::size_t f = 0; f < label.size(); ++f) label[f] = number[find(static_cast<int>(f))];
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
    kept.mass.add(gone.mass);
    for (std::size_t k = 0; k < kept.moments.size(); ++k) kept.moments[k].add(gone.moments[k]);
    kept.misfit += gone.misfit + cost;
    kept.faces += gone.faces;
    for (const auto& [g, border] : gone.adjacent) {
      clusters_[g].adjacent.erase(b);
      if (g == a) continue;
      clusters_[g].adjacent[a].add(border);
      kept.adjacent[g].add(border);
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
  double total_area_ = 0;
};

/// Each face goes with the sample nearest to one of its corners. Each piece of the mesh takes one.
std::vector<int> patchesOf(const TriangleMesh& mesh, int& count) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const std::vector<int> face = vertexFaces(mesh.faces, n);
  const auto loose = static_cast<int>(std::count(face.begin(), face.end(), -1));
  const int pieces = countJoined(n, [&](const auto& join) {
    for (const auto& f : mesh.faces.rowwise())
      for (int v : f) join(f[0], v);
  });
  const Landmarks samples =
      voronoiSamples(mesh, FastMarching(mesh), PATCHES + pieces - loose - 1, 0);
  count = static_cast<int>(samples.vertices.size()) + 1;  // the last: what no sample reaches
  std::vector<int> patch(mesh.faces.rows());
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const int sample = samples.nearest[mesh.faces(f, 0)];
    patch[f] = sample >= 0 ? sample : count - 1;
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
    std::vector<double> sorted = misfit;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double typical = std::max(*middle, 1e-20);  // exact where it is all rigid
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const double ratio = 1 + misfit[i] / typical;
      factor[i] = 1 / (ratio * ratio);  // Geman and McClure
    }
  }
  return motion;
}

}  // namespace

RigidSegments segmentRigidParts(const TriangleMesh& rest, const std::vector<Points>& poses) {
  require(!poses.empty(), "segmentRigidParts: no pose");
  for (const Points& pose : poses)
    require(pose.rows() == rest.vertices.rows(), "segmentRigidParts: one place a vertex");
  const double area = rest.faces.rows() > 0 ? faceAreas(rest).sum() : 0;
  require(area > 0, "segmentRigidParts: a mesh without area");
  const double unit = std::sqrt(area);

  RigidSegments segments;
  const TriangleMesh shape{normalized(rest.vertices, unit), rest.faces};
  std::vector<Points> shapes;
  for (const Points& pose : poses) {
    segments.scale.push_back(medianEdgeRatio(rest, pose));
    shapes.push_back(normalized(pose, unit * segments.scale.back()));
  }
  // Faces without area still have neighbours to go with.
  constexpr double LEAST_AREA = 1e-12;
  const Vector areas = faceAreas(shape).cwiseMax(LEAST_AREA);

  Clustering clustering(shape, shapes, areas);
  int patches = 0;
  const std::vector<int> patch = patchesOf(shape, patches);
  std::vector<double> turns = clustering.turnsBetween(patch, patches);
  for (double& turn : turns) turn = std::cbrt(turn);
  const double root = otsuThreshold(std::move(turns));
  segments.least_turn = std::max(ROUNDING_TURN, root * root * root);
  clustering.mergeDownTo(COMPARABLE);
  clustering.mergeBelow(segments.least_turn);

  segments.face_label = clustering.labels();
  segments.count = 1 + *std::max_element(segments.face_label.begin(), segments.face_label.end());
  segments.label = vertexLabels(shape, areas, segments.face_label);
  std::vector<std::vector<int>> faces(segments.count);
  for (int f = 0; f < rest.faces.rows(); ++f) faces[segments.face_label[f]].push_back(f);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double scale = segments.scale[k];
    const Vector3d from = scale * rest.vertices.colwise().mean().transpose(),
                   to = poses[k].colwise().mean();
    segments.motion.emplace_back();
    for (const std::vector<int>& part : faces) {
      Eigen::Isometry3d motion = robustMotion(shape, shapes[k], areas, part);
      motion.translation() = scale * unit * motion.translation() + to - motion.linear() * from;
      segments.motion.back().push_back(motion);
    }
  }
  return segments;
}

}  // namespace posture
