// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/median.h>
#include <posture/deformation/arap.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include "nearest_rotations.h"
#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

namespace posture {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// The factors L D L' of a matrix whose rows are in order already.
using Factors = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// Solves for all three columns at once: Eigen goes through the factors for one after the other.
void solveInPlace(const Factors& factors, Points& x) {
  const Sparse& lower = factors.matrixL().nestedExpression();  // without its diagonal of ones
  for (int j = 0; j < lower.cols(); ++j) {
    const Eigen::RowVector3d known = x.row(j);
    for (Sparse::InnerIterator it(lower, j); it; ++it) x.row(it.row()) -= it.value() * known;
  }
  x = factors.vectorD().asDiagonal().inverse() * x;
  for (int j = static_cast<int>(lower.cols()) - 1; j >= 0; --j) {
    Eigen::RowVector3d sum = x.row(j);
    for (Sparse::InnerIterator it(lower, j); it; ++it) sum -= it.value() * x.row(it.row());
    x.row(j) = sum;
  }
}

}  // namespace

struct Arap::Impl {
  /// Of positive weight; looked at once for both its ends.
  struct Edge {
    int i, j;
    double weight;
    Eigen::RowVector3d rest;  ///< from j to i
  };

  Eigen::Index vertices() const { return mass.size(); }

  std::vector<Edge> edges;
  Sparse weights;  // n x n, graph Laplacian of the weights w_ij >= 0
  Order order;     // in which few entries fill in when it is factored
  Vector mass;

  std::vector<Eigen::Matrix3d> rotations(const Points& p) const;
  Points rigidPull(const std::vector<Eigen::Matrix3d>& r, const Vector& stiffness) const;
  Vector cellStiffness(const Points& p) const;
  Sparse weightsWith(const Vector& stiffness) const;
  double energy(const Points& p, const std::vector<Eigen::Matrix3d>& r) const;
};

std::vector<Eigen::Matrix3d> Arap::Impl::rotations(const Points& p) const {
  std::vector<Eigen::Matrix3d> r(vertices(), Eigen::Matrix3d::Zero());
  for (const Edge& e : edges) {
    const Eigen::Matrix3d moved = (e.weight * (p.row(e.i) - p.row(e.j))).transpose() * e.rest;
    r[e.i] += moved;
    r[e.j] += moved;
  }
  toNearestRotations(r);
  return r;
}

/// Weights by which squares act like the Charbonnier function of each vertex's strain, whose scale
/// is the median strain: lengths add up beyond it instead of squares.
Vector Arap::Impl::cellStiffness(const Points& p) const {
  const std::vector<Eigen::Matrix3d> r = rotations(p);
  Vector change = Vector::Zero(vertices()), length = change;
  for (const Edge& e : edges) {
    const Eigen::Vector3d bent = (p.row(e.i) - p.row(e.j)).transpose();
    for (int v : {e.i, e.j}) {
      const Eigen::Vector3d rigid = r[v] * e.rest.transpose();
      change[v] += e.weight * (bent - rigid).squaredNorm();
      length[v] += e.weight * rigid.squaredNorm();
    }
  }
  const Vector strain = (length.array() > 0).select(change.cwiseQuotient(length), 0);
  const double typical = median({strain.data(), strain.data() + strain.size()});
  constexpr double RIGID = 1e-12;  // all of it rigid: no strain stands out
  return (1 + strain.array() / std::max(RIGID, typical)).rsqrt();
}

/// The right-hand side the rotated edges at rest make.
Points Arap::Impl::rigidPull(const std::vector<Eigen::Matrix3d>& r, const Vector& stiffness) const {
  Points b = Points::Zero(vertices(), 3);
  for (const Edge& e : edges) {
    const Eigen::RowVector3d turned =
        0.5 * e.weight *
        ((stiffness[e.i] * r[e.i] + stiffness[e.j] * r[e.j]) * e.rest.transpose()).transpose();
    b.row(e.i) += turned;
    b.row(e.j) -= turned;
  }
  return b;
}

/// The weights with each vertex's share of an edge multiplied by its stiffness.
Sparse Arap::Impl::weightsWith(const Vector& stiffness) const {
  Sparse scaled = weights;
  for (int j = 0; j < scaled.outerSize(); ++j) {
    double sum = 0, *diagonal = nullptr;
    for (Sparse::InnerIterator it(scaled, j); it; ++it) {
      if (it.row() == j) {
        diagonal = &it.valueRef();
        continue;
      }
      it.valueRef() *= 0.5 * (stiffness[it.row()] + stiffness[j]);
      sum -= it.value();
    }
    *diagonal = sum;
  }
  return scaled;
}

double Arap::Impl::energy(const Points& p, const std::vector<Eigen::Matrix3d>& r) const {
  double sum = 0;
  for (const Edge& e : edges) {
    const Eigen::Vector3d bent = (p.row(e.i) - p.row(e.j)).transpose();
    for (int v : {e.i, e.j})
      sum += 0.5 * e.weight * (bent - r[v] * e.rest.transpose()).squaredNorm();
  }
  return sum / mass.sum();
}

Arap::Arap(const TriangleMesh& rest, const Laplacian& laplacian) {
  const int n = static_cast<int>(rest.vertices.rows());
  require(laplacian.mass.size() == n, "Arap: the Laplacian is of another mesh");
  auto impl = std::make_unique<Impl>();
  impl->mass = laplacian.mass;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(laplacian.stiffness.nonZeros() + n);
  for (int j = 0; j < n; ++j) {
    entries.emplace_back(j, j, 0.0);
    for (Sparse::InnerIterator it(laplacian.stiffness, j); it; ++it)
      if (it.row() != j && it.value() < 0) {
        entries.emplace_back(it.row(), j, it.value());
        entries.emplace_back(j, j, -it.value());
        const int i = static_cast<int>(it.row());
        if (i < j)
          impl->edges.push_back({i, j, -it.value(), rest.vertices.row(i) - rest.vertices.row(j)});
      }
  }
  impl->weights.resize(n, n);
  impl->weights.setFromTriplets(entries.begin(), entries.end());
  Order inverse;
  Eigen::AMDOrdering<int>()(impl->weights, inverse);
  impl->order = inverse.inverse();
  impl_ = std::move(impl);
}

Arap::~Arap() = default;
Arap::Arap(Arap&&) noexcept = default;
Arap& Arap::operator=(Arap&&) noexcept = default;

std::vector<Eigen::Matrix3d> Arap::rotations(const Points& bent) const {
  require(bent.rows() == impl_->vertices(), "Arap: one place a vertex");
  return impl_->rotations(bent);
}

struct Arap::Attraction::Impl {
  Vector strength;   // of each goal
  Vector stiffness;  // of each vertex's surroundings
  Factors factors;   // of the system in the surface's order
};

Arap::Attraction::Attraction(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Arap::Attraction::~Attraction() = default;
Arap::Attraction::Attraction(Attraction&&) noexcept = default;
Arap::Attraction& Arap::Attraction::operator=(Attraction&&) noexcept = default;

Arap::Attraction Arap::attract(double softness,
                               const Vector& confidence,
                               const Points& bent) const {
  require(confidence.size() == 0 || confidence.size() == impl_->mass.size(),
          "Arap: one confidence a vertex");
  auto attraction = std::make_unique<Attraction::Impl>();
  // A trace of every goal keeps parts that nothing pulls from being singular.
  constexpr double TRACE = 1e-9;
  attraction->strength = softness * impl_->mass;
  if (confidence.size() > 0) attraction->strength.array() *= confidence.array().max(TRACE);
  attraction->stiffness =
      bent.rows() > 0 ? impl_->cellStiffness(bent) : Vector::Ones(impl_->mass.size());
  Sparse system = impl_->weightsWith(attraction->stiffness);
  system.diagonal() += attraction->strength;
  Sparse ordered;
  ordered = system.twistedBy(impl_->order);
  attraction->factors.compute(ordered);
  if (attraction->factors.info() != Eigen::Success)
    throw std::runtime_error("Arap: singular system");
  return Attraction(std::move(attraction));
}

Points Arap::pull(const Points& start,
                  const Points& goals,
                  const Attraction& attraction,
                  int iterations) const {
  const auto n = impl_->vertices();
  require(start.rows() == n && goals.rows() == n, "Arap: one place and one goal a vertex");
  require(attraction.impl_->strength.size() == n, "Arap: the attraction is of another surface");
  const Points pull = attraction.impl_->strength.asDiagonal() * goals;
  Points places = start;
  for (int i = 0; i < iterations; ++i) {
    const std::vector<Eigen::Matrix3d> r = impl_->rotations(places);
    places = impl_->order * (impl_->rigidPull(r, attraction.impl_->stiffness) + pull);
    solveInPlace(attraction.impl_->factors, places);
    places = (impl_->order.transpose() * places).eval();
  }
  return places;
}

double Arap::energy(const Points& bent) const {
  require(bent.rows() == impl_->vertices(), "Arap: one place a vertex");
  return impl_->energy(bent, impl_->rotations(bent));
}

}  // namespace posture
