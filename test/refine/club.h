// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>

#include <Eigen/Geometry>

#include "support/shapes.h"
#include "support/unit_area.h"
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace posture::test {

/// Where a point of the unit sphere comes to lie on a club: an arm along x, and at its end a flat
/// hand with a thumb on one side and a palm that is hollow.
/// \param out  0 on the round body, 1 at the tip.
inline Eigen::RowVector3d onClub(const Eigen::RowVector3d& p, double out, double thumb) {
  const double around = std::hypot(p.y(), p.z());
  const double thin = 1 - 0.7 * std::clamp(out / 0.2, 0.0, 1.0);
  const double hand = std::clamp((out - 0.7) / 0.1, 0.0, 1.0);
  const double profile =
      around > 0 ? thin * (out > 0 ? std::sqrt(1 - out * out) + 0.2 * (1 - out) : around) / around
                 : 0;
  double y = p.y() * profile * (1 + 1.2 * hand), z = p.z() * profile * (1 - 0.4 * hand);
  if (y > 0) y *= 1 + thumb * hand * std::exp(-std::pow((out - 0.82) / 0.06, 2));  // thumb
  z -= 0.6 * hand * y * y;                                                         // palm
  return {p.x() + 2.2 * out, y, z};
}

/// A club that fits itself in one way only. Of an area of one.
/// \param thumb  its height; clubs with different ones share their numbering.
inline TriangleMesh clubWithHand(double thumb = 0.8, int subdivisions = 4) {
  TriangleMesh mesh = sphere(subdivisions);
  for (auto p : mesh.vertices.rowwise())
    p = onClub(p, std::clamp((p.x() + 0.5) / 1.5, 0.0, 1.0), thumb);
  return unitArea(std::move(mesh));
}

/// A body with a left hand at one end and a right hand at the other. Of an area of one.
inline TriangleMesh bodyWithTwoHands(double thumb, int subdivisions = 5) {
  TriangleMesh mesh = sphere(subdivisions);
  for (auto p : mesh.vertices.rowwise()) {
    const double end = std::copysign(1, p.x());
    p.x() = std::abs(p.x());
    p = onClub(p, p.x(), thumb);
    p.x() *= end;
  }
  return unitArea(std::move(mesh));
}

inline int tipOf(const TriangleMesh& mesh) {
  Eigen::Index tip = 0;
  mesh.vertices.col(0).maxCoeff(&tip);
  return static_cast<int>(tip);
}

/// The club's vertices with the arm wound about itself, the hand by the whole angle.
inline Points wound(const TriangleMesh& mesh, double angle) {
  const double tip = mesh.vertices.col(0).maxCoeff();
  Points places = mesh.vertices;
  for (auto p : places.rowwise()) {
    const double share = std::clamp((0.4 - (tip - p.x())) / 0.25, 0.0, 1.0);
    p = (Eigen::AngleAxisd(share * angle, Eigen::Vector3d::UnitX()) * Eigen::Vector3d(p))
            .transpose();
  }
  return places;
}

/// A club without what was nearer to the tip than `reach`.
struct CutClub {
  CutClub(const TriangleMesh& whole, double reach) {
    const double tip = whole.vertices.col(0).maxCoeff();
    std::vector<int> faces, number(whole.vertices.rows(), -1);
    for (int f = 0; f < whole.faces.rows(); ++f) {
      const auto face = whole.faces.row(f);
      if (std::none_of(
              face.begin(), face.end(), [&](int v) { return whole.vertices(v, 0) > tip - reach; }))
        faces.push_back(f);
    }
    mesh.faces = whole.faces(faces, Eigen::all);
    for (int v : mesh.faces.reshaped()) number[v] = 0;
    for (std::size_t v = 0; v < number.size(); ++v)
      if (number[v] == 0) {
        number[v] = static_cast<int>(of_whole.size());
        of_whole.push_back(static_cast<int>(v));
      }
    for (int& v : mesh.faces.reshaped()) v = number[v];
    mesh.vertices = whole.vertices(of_whole, Eigen::all);
  }

  TriangleMesh mesh;
  std::vector<int> of_whole;  ///< each vertex's number in the whole club
};

/// The arm from 2.2 times `reach` off the tip on, squeezed onto what is left of it when `reach` is
/// cut off, and drawn out again.
struct SqueezedArm {
  SqueezedArm(const TriangleMesh& whole, double reach)
      : root_(whole.vertices.col(0).maxCoeff() - 2.2 * reach) {}

  Points squeezed(Points places) const { return scaled(std::move(places), 1.2 / 2.2); }
  Points drawnOut(Points places) const { return scaled(std::move(places), 2.2 / 1.2); }

 private:
  Points scaled(Points places, double ratio) const {
    for (auto p : places.rowwise())
      if (p.x() > root_) p.x() = root_ + ratio * (p.x() - root_);
    return places;
  }

  double root_;
};

inline std::vector<int> nearestOf(const Points& from, const TriangleMesh& to) {
  const PointIndex index(to.vertices);
  std::vector<int> nearest;
  for (const auto& p : from.rowwise()) nearest.push_back(index.nearest(p.transpose()).index);
  return nearest;
}

/// How far a map of the club to itself is off, in edges, of what is within 0.5 of the tip.
inline double meanMiss(const TriangleMesh& mesh, const std::vector<int>& map) {
  const double tip = mesh.vertices.col(0).maxCoeff();
  double sum = 0;
  int count = 0;
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (tip - mesh.vertices(static_cast<Eigen::Index>(v), 0) > 0.5) continue;
    sum += (mesh.vertices.row(map[v]) - mesh.vertices.row(static_cast<Eigen::Index>(v))).norm();
    ++count;
  }
  return sum / (count * meanEdgeLength(mesh));
}

}  // namespace posture::test
