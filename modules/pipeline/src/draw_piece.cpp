// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "draw_piece.h"

#include <posture/mesh/moment_axes.h>
#include <posture/mesh/rigid_motion.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace posture {
namespace {

/// How far a piece may have to go, in sizes of the body.
constexpr double REACH = 0.2;

/// Of a piece's vertices, to call it placed.
constexpr double MOST = 0.6;

/// In edges: how far off in the mean a piece that fits is, and that a perfect fit may be, as
/// vertices are so far from each other; a point counts FARTHEST at most.
constexpr double FITS = 1.2, PERFECT = 0.5, FARTHEST = 4;

/// Of two places so far apart in the mean, in sizes of the body, where the misfit of one is less
/// than so many times that of the other, it is open which is right.
constexpr double ELSEWHERE = 0.1, AS_WELL = 1.25;

/// Of a piece so many points are drawn.
constexpr int FEW = 200;

constexpr int STEPS = 30;
constexpr std::size_t LEAST_MATCHES = 6;

/// The axes of a piece's own moments, which turn with it; the last one is the longest.
Eigen::Matrix3d ownAxes(const Points& points) {
  return momentAxes(points.rowwise() - points.colwise().mean(), Vector::Ones(points.rows()));
}

/// At most FEW of its points, evenly along its longest axis.
Piece thinned(const Piece& piece, const Eigen::Matrix3d& axes) {
  const Points along = piece.points * axes;
  const int n = static_cast<int>(along.rows()), few = std::min(n, FEW);
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    for (int k = 2; k >= 0; --k)
      if (along(a, k) != along(b, k)) return along(a, k) < along(b, k);
    return a < b;
  });
  std::vector<int> some(few);
  for (int i = 0; i < few; ++i)
    some[i] = order[static_cast<std::size_t>(i) * static_cast<std::size_t>(n) / few];
  return {piece.points(some, Eigen::all), piece.normals(some, Eigen::all), 0};
}

/// None, and by half a right angle and a whole one about the axes and all that halve the angles
/// between two or three of them.
std::vector<Eigen::Isometry3d> turnsAbout(const Eigen::Vector3d& pivot,
                                          const Eigen::Matrix3d& axes) {
  std::vector<Eigen::Isometry3d> all{Eigen::Isometry3d::Identity()};
  const auto add = [&](const Eigen::Vector3d& axis) {
    for (double angle : {M_PI / 4, M_PI / 2})
      all.push_back(Eigen::Translation3d(pivot) *
                    Eigen::AngleAxisd(angle, axes * axis.normalized()) *
                    Eigen::Translation3d(-pivot));
  };
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) add({double(x), double(y), double(z)});
  return all;
}

/// Iterated closest points within a shrinking reach; nothing where too few are in reach.
std::optional<Eigen::Isometry3d> drawn(const TargetPart& target,
                                       const Piece& piece,
                                       Eigen::Isometry3d motion) {
  for (int step = 0; step < STEPS; ++step) {
    const double share = 1 - static_cast<double>(step) / STEPS;
    const double reach = std::max(ON_SURFACE, share * REACH * target.size() / target.edge());
    const std::vector<TargetPart::Near> near = target.nearest(piece, motion);
    std::vector<int> rows, goals;
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (near[i].distance > reach || !near[i].same_way) continue;
      rows.push_back(static_cast<int>(i));
      goals.push_back(near[i].vertex);
    }
    if (rows.size() < LEAST_MATCHES) return {};
    const Points places = moved(motion, piece.points(rows, Eigen::all));
    motion = rigidMotion(places, target.places(goals)) * motion;
  }
  return motion;
}

/// Mean distance in edges; a place that looks the other way, or far off, counts as FARTHEST.
double misfit(const TargetPart& target, const Piece& piece, const Eigen::Isometry3d& motion) {
  double sum = 0;
  const std::vector<TargetPart::Near> near = target.nearest(piece, motion);
  for (const TargetPart::Near& at : near)
    sum += at.same_way ? std::min(FARTHEST, at.distance) : FARTHEST;
  return sum / static_cast<double>(near.size());
}

}  // namespace

TargetPart::TargetPart(
    const Points& vertices, const Points& normals, std::vector<int> part, double edge, double size)
    : vertices_(vertices), normals_(normals), vertex_(std::move(part)), edge_(edge), size_(size) {
  if (!vertex_.empty()) index_.emplace(vertices(vertex_, Eigen::all));
}

TargetPart::Near TargetPart::nearest(const Eigen::RowVector3d& place) const {
  const PointIndex::Neighbor found = index_->nearest(place.transpose());
  return {vertex_[found.index], found.distance / edge_};
}

std::vector<TargetPart::Near> TargetPart::nearest(const Piece& piece,
                                                  const Eigen::Isometry3d& motion) const {
  const Points places = moved(motion, piece.points);
  std::vector<Near> near;
  for (int i = 0; i < places.rows(); ++i) {
    near.push_back(nearest(places.row(i)));
    const Eigen::Vector3d normal = motion.linear() * piece.normals.row(i).transpose();
    near.back().same_way = normal.dot(normals_.row(near.back().vertex)) >= 0;
  }
  return near;
}

Points TargetPart::places(const std::vector<int>& vertices) const {
  return vertices_(vertices, Eigen::all);
}

Points moved(const Eigen::Isometry3d& motion, const Points& points) {
  return (points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
}

bool liesOn(const TargetPart& target, const Piece& piece, const Eigen::Isometry3d& motion) {
  if (target.empty()) return false;
  const std::vector<TargetPart::Near> near = target.nearest(piece, motion);
  const auto on = std::count_if(near.begin(), near.end(), [](const TargetPart::Near& at) {
    return at.distance < ON_SURFACE && at.same_way;
  });
  return static_cast<double>(on) >= MOST * static_cast<double>(near.size());
}

std::optional<Eigen::Isometry3d> drawPiece(const TargetPart& target,
                                           const Piece& piece,
                                           const Eigen::Isometry3d& motion) {
  if (target.empty()) return {};
  const Eigen::Matrix3d axes = ownAxes(piece.points);
  const Piece few = thinned(piece, axes);
  std::vector<Eigen::Isometry3d> motions;
  std::vector<double> costs;
  for (const Eigen::Isometry3d& turn : turnsAbout(piece.points.row(piece.first), axes)) {
    const std::optional<Eigen::Isometry3d> there = drawn(target, few, motion * turn);
    if (!there) continue;
    motions.push_back(*there);
    costs.push_back(misfit(target, few, *there));
  }
  if (motions.empty()) return {};
  const auto best = std::min_element(costs.begin(), costs.end()) - costs.begin();
  if (!(costs[best] < FITS) || !liesOn(target, piece, motions[best])) return {};
  const Points places = moved(motions[best], few.points);
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (costs[i] < AS_WELL * std::max(PERFECT, costs[best]) &&
        (moved(motions[i], few.points) - places).rowwise().norm().mean() >
            ELSEWHERE * target.size())
      return {};
  return motions[best];
}

}  // namespace posture
