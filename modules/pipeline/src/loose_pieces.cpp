// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loose_pieces.h"

#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/point_index.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// Of the square root of the area: how much of the surface next to a piece tells its motion, and
/// how far the piece may have to go from there.
constexpr double SURROUNDINGS = 0.15, REACH = 0.2;

/// The same: a piece nowhere farther from the main surface - an eye, a button, a crumb - goes where
/// the vertex next to it goes, when it does not find a better place.
constexpr double BESIDE = 0.1;

/// In mean edges of the target: what lies this near to its surface lies on it.
constexpr double ON_SURFACE = 2;

/// Of a piece's vertices, to call it placed.
constexpr double MOST = 0.6;

/// In the same unit: how far off in the mean a piece that fits is; a point counts FARTHEST at most.
constexpr double FITS = 1.2, FARTHEST = 4;

/// Of two places so far apart in the mean, in square roots of the area, where the misfit of one is
/// less than so many times that of the other, it is open which is right.
constexpr double ELSEWHERE = 0.1, AS_WELL = 1.25;

/// Of a piece so many points are drawn.
constexpr int FEW = 500;

constexpr int STEPS = 30;
constexpr std::size_t LEAST_NEIGHBORS = 6;

/// Fewer vertices have no motion of their own: they stay with the vertex next to them.
constexpr std::size_t LEAST_PIECE = 3;

struct Rigid {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::RowVector3d translation = Eigen::RowVector3d::Zero();

  Points of(const Points& points) const {
    return (points * rotation.transpose()).rowwise() + translation;
  }
};

Rigid bestRigid(const Points& from, const Points& to) {
  const Eigen::RowVector3d mean_from = from.colwise().mean(), mean_to = to.colwise().mean();
  const Eigen::Matrix3d moment =
      (to.rowwise() - mean_to).transpose() * (from.rowwise() - mean_from);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d sign(1, 1, 1);
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) sign[2] = -1;
  Rigid motion;
  motion.rotation = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  motion.translation = mean_to - mean_from * motion.rotation.transpose();
  return motion;
}

/// None, and about six axes by half a right angle and by a whole one.
std::vector<Eigen::Matrix3d> turns() {
  std::vector<Eigen::Matrix3d> all{Eigen::Matrix3d::Identity()};
  for (double angle : {M_PI / 4, M_PI / 2})
    for (int axis = 0; axis < 3; ++axis)
      for (double sign : {1.0, -1.0})
        all.push_back(Eigen::AngleAxisd(sign * angle, Eigen::Vector3d::Unit(axis)).matrix());
  return all;
}

/// At most FEW of a piece's points, evenly over their list.
std::vector<int> spread(const Points& points) {
  const int n = static_cast<int>(points.rows()), few = std::min(n, FEW);
  std::vector<int> some(few);
  for (int i = 0; i < few; ++i) some[i] = static_cast<int>(static_cast<long long>(i) * n / few);
  return some;
}

/// Vertices off the main surface, joined where faces join them or they are at one place; single
/// points in no face are pieces of their own. By their first vertex.
std::vector<std::vector<int>> loosePieces(const GivenShape& shape) {
  const int n = static_cast<int>(shape.input.vertices.rows());
  std::vector<int> parent(n);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const auto join = [&](int a, int b) {
    a = root(a);
    b = root(b);
    parent[std::max(a, b)] = std::min(a, b);
  };
  const auto loose = [&](int v) { return shape.clean.offset[v] > 0; };
  for (int f = 0; f < shape.input.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = shape.input.faces(f, k), b = shape.input.faces(f, (k + 1) % 3);
      if (loose(a) && loose(b)) join(a, b);
    }
  std::vector<int> by_place(n);
  std::iota(by_place.begin(), by_place.end(), 0);
  const auto before = [&](int a, int b) {
    for (int k = 0; k < 3; ++k)
      if (shape.input.vertices(a, k) != shape.input.vertices(b, k))
        return shape.input.vertices(a, k) < shape.input.vertices(b, k);
    return a < b;
  };
  std::sort(by_place.begin(), by_place.end(), before);
  for (int i = 1; i < n; ++i)
    if (shape.input.vertices.row(by_place[i]) == shape.input.vertices.row(by_place[i - 1]))
      join(by_place[i], by_place[i - 1]);

  std::vector<int> number(n, -1);
  std::vector<std::vector<int>> pieces;
  for (int v = 0; v < n; ++v) {
    if (!loose(v)) continue;
    int& piece = number[root(v)];
    if (piece < 0) {
      piece = static_cast<int>(pieces.size());
      pieces.emplace_back();
    }
    pieces[piece].push_back(v);
  }
  return pieces;
}

/// A part of the target's vertices to look for neighbours in.
class TargetPart {
 public:
  template <class Keep>
  TargetPart(const TriangleMesh& mesh, const Keep& keep) : mesh_(mesh) {
    for (int v = 0; v < mesh.vertices.rows(); ++v)
      if (keep(v)) vertex_.push_back(v);
    if (!vertex_.empty()) index_.emplace(mesh.vertices(vertex_, Eigen::all));
  }
  bool empty() const { return vertex_.empty(); }

  struct Near {
    int vertex;
    double distance;
  };
  Near nearest(const Eigen::RowVector3d& place) const {
    const PointIndex::Neighbor found = index_->nearest(place.transpose());
    return {vertex_[found.index], found.distance};
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<int> vertex_;
  std::optional<PointIndex> index_;
};

class Placing {
 public:
  Placing(const GivenShape& source, const GivenShape& target, RegistrationResult& result)
      : source_(source),
        target_(target),
        result_(result),
        edge_(meanEdgeLength(target.clean.mesh)),
        size_(std::sqrt(faceAreas(target.clean.mesh).sum())),
        source_normals_(vertexNormals(source.input)),
        target_normals_(vertexNormals(target.input)),
        target_face_(
            vertexFaces(target.input.faces, static_cast<int>(target.input.vertices.rows()))),
        whole_(target.input, [&](int v) { return v < target.ownVertices(); }),
        free_(target.input,
              [&, claimed = claimed()](int v) { return v < target.ownVertices() && !claimed[v]; }),
        main_(source.input.vertices, source.clean) {}

  void place(const std::vector<int>& piece) {
    if (piece.size() < LEAST_PIECE) return placeSingly(piece);
    const Points rest = result_.scale * source_.input.vertices(piece, Eigen::all);
    const Points normals = source_normals_(piece, Eigen::all);
    const std::optional<Rigid> beside = motionBeside(piece);
    if (!beside) return leaveOut(piece);
    const bool is_beside = isBeside(piece);
    if (is_beside && settled(*beside, rest, normals, whole_))
      return put(piece, *beside, rest, normals, whole_);
    const std::optional<Rigid> drawn = bestDrawn(*beside, rest, normals, nearestToMain(piece));
    if (drawn) return put(piece, *drawn, rest, normals, free_);
    result_.deformed(piece, Eigen::all) = beside->of(rest);
    if (!is_beside) leaveOut(piece);
  }

 private:
  bool isBeside(const std::vector<int>& piece) const {
    return std::all_of(piece.begin(), piece.end(), [&](int v) {
      return result_.scale * source_.clean.offset[v] < BESIDE * size_;
    });
  }

  void placeSingly(const std::vector<int>& vertices) {
    for (int v : vertices) {
      const TargetPart::Near near = whole_.nearest(result_.deformed.row(v));
      if (near.distance < ON_SURFACE * edge_)
        match(v, near);
      else if (!isBeside({v}))
        leaveOut({v});
    }
  }

  void match(int v, const TargetPart::Near& near) {
    const double miss = near.distance / (ON_SURFACE * edge_);
    result_.correspondence.on_target[v] = atVertex(near.vertex);
    result_.correspondence.confidence[v] = result_.trust / (1 + miss * miss);
  }

  /// The source's main surface, for neighbours.
  class Main {
   public:
    Main(const Points& vertices, const CleanMesh& clean)
        : vertex_(verticesOf(clean)), index_(vertices(vertex_, Eigen::all)) {}

    /// In increasing order; by rounding perhaps some beyond.
    std::vector<int> within(const Eigen::RowVector3d& center, double radius) const {
      std::vector<int> found = index_.within(center.transpose(), radius);
      for (int& v : found) v = vertex_[v];
      return found;
    }

   private:
    static std::vector<int> verticesOf(const CleanMesh& clean) {
      std::vector<int> vertices;
      for (int v = 0; v < clean.offset.size(); ++v)
        if (!(clean.offset[v] > 0)) vertices.push_back(v);
      return vertices;
    }

    std::vector<int> vertex_;
    PointIndex index_;
  };

  /// Target vertices where the source's main surface lies.
  std::vector<char> claimed() const {
    const Points& deformed = result_.deformed;
    std::vector<int> mapped;
    for (int v = 0; v < source_.ownVertices(); ++v)
      if (!(source_.clean.offset[v] > 0) && result_.correspondence.on_target[v].vertex >= 0)
        mapped.push_back(v);
    std::vector<char> claimed(target_.input.vertices.rows(), 0);
    if (mapped.empty()) return claimed;
    const PointIndex index(deformed(mapped, Eigen::all));
    for (std::size_t t = 0; t < claimed.size(); ++t)
      claimed[t] =
          index.nearest(target_.input.vertices.row(static_cast<int>(t)).transpose()).distance <
          ON_SURFACE * edge_;
    return claimed;
  }

  /// The number in it of the vertex of a piece that is nearest to the main surface.
  int nearestToMain(const std::vector<int>& piece) const {
    const auto nearest = std::min_element(piece.begin(), piece.end(), [&](int a, int b) {
      return source_.clean.offset[a] < source_.clean.offset[b];
    });
    return static_cast<int>(nearest - piece.begin());
  }

  /// That of the main surface around the vertex of it that is nearest to the piece.
  std::optional<Rigid> motionBeside(const std::vector<int>& piece) {
    const int nearest = piece[nearestToMain(piece)];
    const Points& all = source_.input.vertices;
    const int anchor = source_.clean.clean_vertex[nearest];
    const auto known = motions_.find(anchor);
    if (known != motions_.end()) return known->second;
    const Eigen::RowVector3d center = all.row(source_.clean.input_vertex[anchor]);
    const double radius = SURROUNDINGS * size_ / result_.scale;
    // Places of vertices that have a counterpart say more than those of others.
    std::vector<int> around, mapped;
    for (int v : main_.within(center, radius))
      if ((all.row(v) - center).norm() < radius) {
        around.push_back(v);
        if (result_.correspondence.on_target[v].vertex >= 0) mapped.push_back(v);
      }
    if (mapped.size() >= LEAST_NEIGHBORS) around = std::move(mapped);
    std::optional<Rigid>& motion = motions_[anchor];
    if (around.size() >= LEAST_NEIGHBORS)
      motion =
          bestRigid(result_.scale * all(around, Eigen::all), result_.deformed(around, Eigen::all));
    return motion;
  }

  bool agree(const Rigid& motion, const Eigen::RowVector3d& normal, int target_vertex) const {
    const Eigen::RowVector3d turned = normal * motion.rotation.transpose();
    return turned.dot(target_normals_.row(target_vertex)) >= 0;
  }

  bool settled(const Rigid& motion,
               const Points& rest,
               const Points& normals,
               const TargetPart& part) const {
    if (part.empty()) return false;
    const Points places = motion.of(rest);
    int on = 0;
    for (int i = 0; i < places.rows(); ++i) {
      const TargetPart::Near near = part.nearest(places.row(i));
      on += near.distance < ON_SURFACE * edge_ && agree(motion, normals.row(i), near.vertex);
    }
    return on >= MOST * static_cast<double>(places.rows());
  }

  /// Where a piece fits what is left free: drawn there from the motion of the surface next to it,
  /// and from that turned every way about the place where the piece begins, as joints may have bent
  /// in the gap. Nothing where it fits nowhere, or elsewhere nearly as well.
  std::optional<Rigid> bestDrawn(const Rigid& beside,
                                 const Points& rest,
                                 const Points& normals,
                                 int first) const {
    if (free_.empty()) return {};
    const std::vector<int> some = spread(rest);
    const Points few = rest(some, Eigen::all), few_normals = normals(some, Eigen::all);
    const Eigen::RowVector3d pivot = beside.of(rest.row(first));
    std::vector<Rigid> motions;
    std::vector<double> costs;
    for (const Eigen::Matrix3d& turn : turns()) {
      Rigid start;
      start.rotation = turn * beside.rotation;
      start.translation = (beside.translation - pivot) * turn.transpose() + pivot;
      motions.push_back(drawnTo(free_, start, few, few_normals));
      costs.push_back(misfit(motions.back(), few, few_normals));
    }
    const auto best = std::min_element(costs.begin(), costs.end()) - costs.begin();
    if (!(costs[best] < FITS) || !settled(motions[best], rest, normals, free_)) return {};
    const Points places = motions[best].of(few);
    for (std::size_t i = 0; i < motions.size(); ++i)
      if (costs[i] < AS_WELL * costs[best] &&
          (motions[i].of(few) - places).rowwise().norm().mean() > ELSEWHERE * size_)
        return {};
    return motions[best];
  }

  /// Mean distance from the free surface, in edges; a place that looks the other way, or far off,
  /// counts as FARTHEST.
  double misfit(const Rigid& motion, const Points& rest, const Points& normals) const {
    const Points places = motion.of(rest);
    double sum = 0;
    for (int i = 0; i < places.rows(); ++i) {
      const TargetPart::Near near = free_.nearest(places.row(i));
      sum += agree(motion, normals.row(i), near.vertex) ? std::min(FARTHEST, near.distance / edge_)
                                                        : FARTHEST;
    }
    return sum / static_cast<double>(places.rows());
  }

  /// Iterated closest points within a shrinking reach.
  Rigid drawnTo(const TargetPart& part,
                Rigid motion,
                const Points& rest,
                const Points& normals) const {
    if (part.empty()) return motion;
    for (int step = 0; step < STEPS; ++step) {
      const double share = 1 - static_cast<double>(step) / STEPS;
      const double reach = std::max(ON_SURFACE * edge_, share * REACH * size_);
      const Points places = motion.of(rest);
      std::vector<int> moved, goals;
      for (int i = 0; i < places.rows(); ++i) {
        const TargetPart::Near near = part.nearest(places.row(i));
        if (near.distance > reach || !agree(motion, normals.row(i), near.vertex)) continue;
        moved.push_back(i);
        goals.push_back(near.vertex);
      }
      if (moved.size() < LEAST_NEIGHBORS) return motion;
      motion = bestRigid(rest(moved, Eigen::all), target_.input.vertices(goals, Eigen::all));
    }
    return motion;
  }

  void put(const std::vector<int>& piece,
           const Rigid& motion,
           const Points& rest,
           const Points& normals,
           const TargetPart& part) {
    const Points places = motion.of(rest);
    result_.deformed(piece, Eigen::all) = places;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const int row = static_cast<int>(i);
      const TargetPart::Near near = part.nearest(places.row(row));
      if (near.distance < ON_SURFACE * edge_ && agree(motion, normals.row(row), near.vertex))
        match(piece[i], near);
      else
        leaveOut({piece[i]});
    }
  }

  SurfacePoint atVertex(int vertex) const {
    SurfacePoint place;
    place.vertex = vertex;
    place.face = target_face_[vertex];
    for (int k = 0; k < 3 && place.face >= 0; ++k)
      place.barycentric[k] = target_.input.faces(place.face, k) == vertex;
    return place;
  }

  void leaveOut(const std::vector<int>& piece) {
    for (int v : piece) {
      result_.correspondence.on_target[v] = {};
      result_.correspondence.confidence[v] = 0;
    }
  }

  const GivenShape &source_, &target_;
  RegistrationResult& result_;
  double edge_, size_;
  Points source_normals_, target_normals_;
  std::vector<int> target_face_;
  TargetPart whole_, free_;
  Main main_;
  std::map<int, std::optional<Rigid>> motions_;  // by the vertex next to the piece
};

}  // namespace

void placeLoosePieces(const GivenShape& source,
                      const GivenShape& target,
                      RegistrationResult& result) {
  const std::vector<std::vector<int>> pieces = loosePieces(source);
  if (pieces.empty()) return;
  Placing placing(source, target, result);
  for (const std::vector<int>& piece : pieces) placing.place(piece);
}

}  // namespace posture
