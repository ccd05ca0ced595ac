// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/map_score.h>

#include <Eigen/Geometry>

#include "belief.h"
#include "functional_map.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

using Block = Eigen::MatrixXf;

/// Sizes of basis: bending wants the body's large forms, areas its details too, and eigenvalues
/// agree between like shapes for the lower ones alone.
constexpr int BENDING_BASIS = 60, DETAIL_BASIS = 100, COMMUTATOR_BASIS = 50;

double bendingEnergy(const SpectralSurface& from,
                     const SpectralSurface& to,
                     const std::vector<int>& matches,
                     int k,
                     double softness) {
  const Points goals = rowsAt(to.mesh.vertices, matches);
  const Arap::Attraction attraction = from.arap.attract(softness, belief(from, to, matches));
  return from.arap.pull(lowPass(from, goals, k), goals, attraction, 2 * BENDING_STEPS).energy;
}

/// Mean curvature, positive where the surface bulges, smoothed.
Vector meanCurvature(const SpectralSurface& s, int k) {
  const Points integrated = s.laplacian.stiffness * s.mesh.vertices;
  const Vector along_normal = 0.5 * integrated.cwiseProduct(s.normals).rowwise().sum();
  return lowPass(s, along_normal.cwiseQuotient(s.laplacian.mass), k);
}

double correlation(const Vector& x, const Vector& y, const Vector& mass) {
  const Vector w = mass / mass.sum();
  const Vector dx = x.array() - w.dot(x), dy = y.array() - w.dot(y);
  const double spread = std::sqrt(w.dot(dx.cwiseAbs2()) * w.dot(dy.cwiseAbs2()));
  return spread > 0 ? w.dot(dx.cwiseProduct(dy)) / spread : 1;
}

double commutator(const Block& c, const Eigen::VectorXf& before, const Eigen::VectorXf& after) {
  const Block left = before.asDiagonal() * c, right = c * after.asDiagonal();
  return (left - right).squaredNorm() / left.squaredNorm();
}

/// Zero for the functional map of an area-preserving map, whichever way it turns the functions.
double orthogonalityDefect(const Block& c) {
  const Block product = c.transpose() * c;
  return (product - Block::Identity(c.rows(), c.cols())).squaredNorm() / c.rows();
}

double oneWayOrientation(const SpectralSurface& a,
                         const SpectralSurface& b,
                         const std::vector<int>& map) {
  double vote = 0, area = 0;
  for (int f = 0; f < a.mesh.faces.rows(); ++f) {
    Eigen::Matrix3d corners;
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const int at = map[a.mesh.faces(f, k)];
      corners.col(k) = b.mesh.vertices.row(at).transpose();
      expected += b.normals.row(at).transpose();
    }
    const Eigen::Vector3d normal =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const double agreement = normal.dot(expected), weight = normal.norm();
    vote += agreement > 0 ? weight : (agreement < 0 ? -weight : 0);
    area += weight;
  }
  return area > 0 ? vote / area : 0;
}

}  // namespace

double MapScore::total() const {
  // A perfect map must not win by a lucky zero in one term.
  constexpr double LEAST = 1e-4;
  double sum = 0;
  for (double term : {bending, curvature, orthogonality, commutator})
    sum += std::log(std::max(LEAST, term));
  return sum;
}

MapScore scoreMaps(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps) {
  MapScore score;
  const int k = basisSize(a, b, BENDING_BASIS);
  const double softness = eigenvalueAt(a, b, k);
  score.bending = 0.5 * (bendingEnergy(a, b, maps.forward, k, softness) +
                         bendingEnergy(b, a, maps.backward, k, softness));

  const int detail = basisSize(a, b, DETAIL_BASIS);
  const Vector curvature_a = meanCurvature(a, detail), curvature_b = meanCurvature(b, detail);
  score.curvature =
      1 - 0.5 * (correlation(curvature_a, rowsAt(curvature_b, maps.forward), a.laplacian.mass) +
                 correlation(curvature_b, rowsAt(curvature_a, maps.backward), b.laplacian.mass));

  const FunctionalMaps c = fitFunctionalMaps(a, b, detail, maps);
  score.orthogonality = 0.5 * (orthogonalityDefect(c.ab) + orthogonalityDefect(c.ba));

  const int low = basisSize(a, b, COMMUTATOR_BASIS);
  const FunctionalMaps d = fitFunctionalMaps(a, b, low, maps);
  const Eigen::VectorXf values_a = a.eigenvalues.head(low).cast<float>(),
                        values_b = b.eigenvalues.head(low).cast<float>();
  score.commutator =
      0.5 * (commutator(d.ab, values_a, values_b) + commutator(d.ba, values_b, values_a));
  return score;
}

double orientation(const SpectralSurface& a, const SpectralSurface& b, const VertexMaps& maps) {
  return 0.5 * (oneWayOrientation(a, b, maps.forward) + oneWayOrientation(b, a, maps.backward));
}

}  // namespace posture
