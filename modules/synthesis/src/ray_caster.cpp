// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/synthesis/ray_caster.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace posture {
namespace {

constexpr int LEAF_FACES = 4;

/// Does the ray pass through the box before `farthest`?
bool passes(const Eigen::Vector3d& low,
            const Eigen::Vector3d& high,
            const Eigen::Vector3d& origin,
            const Eigen::Vector3d& inverse,
            double farthest) {
  double enter = 0, leave = farthest;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (low[axis] - origin[axis]) * inverse[axis],
                 b = (high[axis] - origin[axis]) * inverse[axis];
    if (std::isnan(a) || std::isnan(b)) continue;  // the ray runs in the plane of a side
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  constexpr double SLACK = 1 + 1e-12;  // rounding must not lose a face in its own box's side
  return enter <= leave * SLACK;
}

}  // namespace

RayCaster::RayCaster(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.faces.rows()) {
  const bool fits = mesh.faces.rows() == 0 ||
                    (mesh.faces.minCoeff() >= 0 && mesh.faces.maxCoeff() < mesh.vertices.rows());
  require(fits, "ray caster: a face names a vertex that is not there");
  std::iota(order_.begin(), order_.end(), 0);
  Points centers(mesh.faces.rows(), 3);
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f)
    centers.row(f) = (mesh.vertices.row(mesh.faces(f, 0)) + mesh.vertices.row(mesh.faces(f, 1)) +
                      mesh.vertices.row(mesh.faces(f, 2))) /
                     3;
  if (!order_.empty()) build(0, static_cast<int>(order_.size()), centers);
}

void RayCaster::build(int begin, int end, const Points& centers) {
  const std::size_t here = nodes_.size();
  nodes_.emplace_back();
  Eigen::AlignedBox3d box, center_box;
  for (int i = begin; i < end; ++i) {
    center_box.extend(centers.row(order_[i]).transpose());
    for (int corner = 0; corner < 3; ++corner)
      box.extend(mesh_.vertices.row(mesh_.faces(order_[i], corner)).transpose());
  }
  nodes_[here].low = box.min();
  nodes_[here].high = box.max();
  if (end - begin <= LEAF_FACES) {
    nodes_[here].begin = begin;
    nodes_[here].end = end;
    return;
  }
  int axis = 0;
  center_box.sizes().maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
        const double x = centers(a, axis), y = centers(b, axis);
        return x < y || (x == y && a < b);
      });
  build(begin, middle, centers);
  nodes_[here].second = static_cast<int>(nodes_.size());
  build(middle, end, centers);
}

RayHit RayCaster::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
  RayHit best;
  if (nodes_.empty()) return best;
  const Eigen::Vector3d inverse = direction.cwiseInverse();
  // Halving splits: no deeper than the binary digits of a face number, and one brother a level.
  int stack[64];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const int number = stack[--size];
    const Node& node = nodes_[number];
    if (!passes(node.low, node.high, origin, inverse, best.distance)) continue;
    for (int i = node.begin; i < node.end; ++i) meet(order_[i], origin, direction, best);
    if (node.begin != node.end) continue;
    stack[size++] = node.second;
    stack[size++] = number + 1;
  }
  return best;
}

void RayCaster::meet(int face,
                     const Eigen::Vector3d& origin,
                     const Eigen::Vector3d& direction,
                     RayHit& best) const {
  const Eigen::Vector3d a = mesh_.vertices.row(mesh_.faces(face, 0));
  const Eigen::Vector3d ab = mesh_.vertices.row(mesh_.faces(face, 1)).transpose() - a;
  const Eigen::Vector3d ac = mesh_.vertices.row(mesh_.faces(face, 2)).transpose() - a;
  const Eigen::Vector3d p = direction.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0) return;
  const Eigen::Vector3d from_a = origin - a, q = from_a.cross(ab);
  const double u = from_a.dot(p) / determinant, v = direction.dot(q) / determinant;
  const double distance = ac.dot(q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && distance >= 0)) return;
  if (distance > best.distance || (distance == best.distance && face > best.face)) return;
  best.face = face;
  best.distance = distance;
  best.barycentric = {1 - u - v, u, v};
}

}  // namespace posture
