// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "orient_faces.h"

#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace posture {
namespace {

using Eigen::Vector3d;

/// The largest patch encloses a volume where the lids of its holes come to no more than this of its
/// area: those of three quarters of a sphere. Of bodies with holes all over they come to less than
/// 0.15, of what a scanner sees from one side to more than all of it.
constexpr double MOST_LIDS = 0.25;

/// And it is this much at least, with areas of 1: 0.016 to 0.05 of bodies, 0.094 of a sphere, next
/// to nothing of two layers of cloth.
constexpr double LEAST_VOLUME = 0.003;

/// Of the area, less what faces the other way: where faces were given every which way, nothing was
/// inside out.
constexpr double NEARLY_ALL = 0.8;

bool hasDirectedEdge(const Faces& faces, int face, int from, int to) {
  for (int k = 0; k < 3; ++k)
    if (faces(face, k) == from && faces(face, (k + 1) % 3) == to) return true;
  return false;
}

class Orienter {
 public:
  Orienter(TriangleMesh& mesh, Facing facing)
      : mesh_(mesh),
        facing_(facing),
        given_(mesh.faces),
        across_(facesAcross(mesh.faces)),
        areas_(faceAreas(mesh)),
        visited_(mesh.faces.rows(), 0) {}

  Orientation run() {
    const std::vector<Patch> patches = grown();
    Orientation orientation;
    const Patch* const main = largest(patches);
    if (main != nullptr) {
      const Enclosed enclosed = volumeOf(*main);
      orientation.outward_known =
          main->orientable && enclosed.lids <= MOST_LIDS * main->area &&
          std::abs(enclosed.volume) > LEAST_VOLUME * std::pow(main->area, 1.5);
      const bool against = (enclosed.volume < 0) != (main->agreeing < 0);
      orientation.inside_out = orientation.outward_known && facing_ == Facing::OUTWARD && against &&
                               std::abs(main->agreeing) > NEARLY_ALL * main->area;
    }
    for (const Patch& patch : patches) {
      const bool by_volume = facing_ == Facing::OUTWARD &&
                             ((&patch == main && orientation.outward_known) || patch.isClosed());
      if (by_volume ? volumeOf(patch).volume < 0 : (patch.agreeing < 0) != orientation.inside_out)
        turn(patch);
    }
    for (int f = 0; f < given_.rows(); ++f)
      orientation.turned.push_back(mesh_.faces.row(f) != given_.row(f));
    return orientation;
  }

  void runOnPieces() {
    for (const Patch& patch : grown())
      if (patch.isClosed() ? volumeOf(patch).volume < 0 : patch.agreeing < 0) turn(patch);
  }

 private:
  struct Patch {
    std::vector<int> faces;
    std::vector<std::pair<int, int>> rim;  ///< as the faces there run
    bool orientable = true;
    double area = 0, agreeing = 0;  ///< that faces as it was given less what does not

    bool isClosed() const { return rim.empty() && orientable; }
  };

  struct Enclosed {
    double volume = 0, lids = 0;
  };

  std::vector<Patch> grown() {
    std::vector<Patch> patches;
    for (int seed = 0; seed < given_.rows(); ++seed)
      if (!visited_[seed]) patches.push_back(grow(seed));
    return patches;
  }

  static const Patch* largest(const std::vector<Patch>& patches) {
    const auto less = [](const Patch& a, const Patch& b) { return a.area < b.area; };
    const auto found = std::max_element(patches.begin(), patches.end(), less);
    return found == patches.end() ? nullptr : &*found;
  }

  void turn(const Patch& patch) {
    for (int f : patch.faces) flip(f);
  }

  /// Turns all that can be reached from a face the way that face is.
  Patch grow(int seed) {
    visited_[seed] = 1;
    Patch patch;
    patch.faces.push_back(seed);
    for (std::size_t next = 0; next < patch.faces.size(); ++next) {
      const int f = patch.faces[next];
      patch.area += areas_[f];
      patch.agreeing += mesh_.faces.row(f) == given_.row(f) ? areas_[f] : -areas_[f];
      for (int k = 0; k < 3; ++k) {
        const int g = across_(f, k);
        const int a = given_(f, k), b = given_(f, (k + 1) % 3);
        const bool f_runs_ab = hasDirectedEdge(mesh_.faces, f, a, b);
        if (g < 0) patch.rim.push_back(f_runs_ab ? std::pair(a, b) : std::pair(b, a));
        if (g < 0) continue;
        const bool alike = hasDirectedEdge(mesh_.faces, g, a, b) != f_runs_ab;
        if (visited_[g]) {
          patch.orientable = patch.orientable && alike;
          continue;
        }
        visited_[g] = 1;
        if (!alike) flip(g);
        patch.faces.push_back(g);
      }
    }
    return patch;
  }

  /// With a lid on each connected part of the rim: a fan about its centroid.
  Enclosed volumeOf(const Patch& patch) const {
    const Vector3d origin = mesh_.vertices.row(mesh_.faces(patch.faces[0], 0));
    Enclosed enclosed;
    const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
      enclosed.volume += (a - origin).dot((b - origin).cross(c - origin)) / 6;
    };
    for (int f : patch.faces) add(corner(f, 0), corner(f, 1), corner(f, 2));
    const std::map<int, Vector3d> middles = middlesOf(patch.rim);
    for (const auto& [from, to] : patch.rim) {
      const Vector3d a = mesh_.vertices.row(to), b = mesh_.vertices.row(from);
      const Vector3d& c = middles.at(from);
      add(a, b, c);
      enclosed.lids += (b - a).cross(c - a).norm() / 2;
    }
    return enclosed;
  }

  /// For each vertex of a rim the centroid of the connected part it is in.
  std::map<int, Vector3d> middlesOf(const std::vector<std::pair<int, int>>& rim) const {
    std::multimap<int, int> next;
    for (const auto& [from, to] : rim) {
      next.emplace(from, to);
      next.emplace(to, from);
    }
    std::map<int, Vector3d> middle;
    for (const auto& start : next) {
      if (middle.count(start.first) > 0) continue;
      std::vector<int> part{start.first};
      middle[start.first] = Vector3d::Zero();
      Vector3d sum = Vector3d::Zero();
      for (std::size_t i = 0; i < part.size(); ++i) {
        sum += mesh_.vertices.row(part[i]).transpose();
        const auto [begin, end] = next.equal_range(part[i]);
        for (auto it = begin; it != end; ++it)
          if (middle.emplace(it->second, Vector3d::Zero()).second) part.push_back(it->second);
      }
      for (int v : part) middle[v] = sum / static_cast<double>(part.size());
    }
    return middle;
  }

  Vector3d corner(int face, int k) const { return mesh_.vertices.row(mesh_.faces(face, k)); }

  void flip(int face) { std::swap(mesh_.faces(face, 1), mesh_.faces(face, 2)); }

  TriangleMesh& mesh_;
  const Facing facing_;
  const Faces given_, across_;
  const Vector areas_;
  std::vector<char> visited_;
};

}  // namespace

Orientation orientFaces(TriangleMesh& mesh, Facing facing) { return Orienter(mesh, facing).run(); }

void orientPieces(TriangleMesh& pieces) { Orienter(pieces, Facing::OUTWARD).runOnPieces(); }

}  // namespace posture
