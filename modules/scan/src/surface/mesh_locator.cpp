// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/mesh_locator.h"

#include <posture/core/error.h>
#include <posture/mesh/nearest_on_faces.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace posture {

struct MeshLocator::Tree {
  struct Node {
    Eigen::AlignedBox3d box;
    int first, last;          ///< range of `order`
    int left = 0, right = 0;  ///< 0: a leaf
  };

  const TriangleMesh& mesh;
  std::vector<int> order;  ///< faces
  std::vector<Node> nodes;

  explicit Tree(const TriangleMesh& m) : mesh(m), order(m.faces.rows()) {
    std::iota(order.begin(), order.end(), 0);
    Points centers(mesh.faces.rows(), 3);
    for (int f = 0; f < mesh.faces.rows(); ++f)
      centers.row(f) = mesh.vertices(mesh.faces.row(f), Eigen::all).colwise().mean();
    nodes.reserve(mesh.faces.rows());
    build(centers, 0, static_cast<int>(order.size()));
  }

  Eigen::Vector3d corner(int face, int k) const { return mesh.vertices.row(mesh.faces(face, k)); }

  int build(const Points& centers, int first, int last) {
    constexpr int LEAF = 4;
    const int number = static_cast<int>(nodes.size());
    nodes.push_back({{}, first, last});
    Eigen::AlignedBox3d spread;
    for (int i = first; i < last; ++i) {
      spread.extend(centers.row(order[i]).transpose());
      for (int k = 0; k < 3; ++k) nodes[number].box.extend(corner(order[i], k));
    }
    if (last - first <= LEAF) return number;
    int axis = 0;
    spread.sizes().maxCoeff(&axis);
    const int middle = (first + last) / 2;
    std::nth_element(
        order.begin() + first, order.begin() + middle, order.begin() + last, [&](int a, int b) {
          return centers(a, axis) != centers(b, axis) ? centers(a, axis) < centers(b, axis) : a < b;
        });
    const int left = build(centers, first, middle);
    const int right = build(centers, middle, last);
    nodes[number].left = left;
    nodes[number].right = right;
    return number;
  }

  void tryFace(int face, const Eigen::Vector3d& p, NearestPlace& best) const {
    NearestPlace there;
    lookInFace(mesh.vertices, mesh.faces, face, p, there);
    if (there.squared < best.squared || (there.squared == best.squared && face < best.face))
      best = there;
  }

  void search(int number, const Eigen::Vector3d& p, NearestPlace& best) const {
    const Node& node = nodes[number];
    if (node.left == 0) {
      for (int i = node.first; i < node.last; ++i) tryFace(order[i], p, best);
      return;
    }
    int near = node.left, far = node.right;
    double near_sq = nodes[near].box.squaredExteriorDistance(p);
    double far_sq = nodes[far].box.squaredExteriorDistance(p);
    if (far_sq < near_sq) {
      std::swap(near, far);
      std::swap(near_sq, far_sq);
    }
    if (near_sq <= best.squared) search(near, p, best);
    if (far_sq <= best.squared) search(far, p, best);
  }
};

MeshLocator::MeshLocator(const TriangleMesh& mesh) : tree_(std::make_unique<Tree>(mesh)) {}
MeshLocator::~MeshLocator() = default;

MeshLocator::Place MeshLocator::nearest(const Eigen::Vector3d& point) const {
  NearestPlace best;
  tree_->search(0, point, best);
  require(best.face >= 0, "MeshLocator: a distance that is not finite");
  Place place{{-1, best.face, best.barycentric}, std::sqrt(best.squared)};
  double shortest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double distance_sq = (tree_->corner(best.face, k) - point).squaredNorm();
    if (distance_sq >= shortest) continue;
    shortest = distance_sq;
    place.on_mesh.vertex = tree_->mesh.faces(best.face, k);
  }
  return place;
}

}  // namespace posture
