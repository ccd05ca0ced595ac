// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/median.h>
#include <posture/deformation/arap.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include "arap_steps.h"
#include "nearest_rotations.h"
#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace posture {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// The factors L D L' of a matrix whose rows are in order already, of which they are made without a
/// copy.
using Factors = Eigen::SimplicialLDLT<Sparse, Eigen::Upper, Eigen::NaturalOrdering<int>>;

}  // namespace

/// All that is said of a vertex here is in the order in which few entries fill in when systems are
/// factored, which also keeps neighbours near each other in memory.
struct Arap::Impl {
  Eigen::Index vertices() const { return mass.size(); }

  Order order;  ///< from the mesh's order to this one
  Vector mass;
  std::vector<RigidEdge> edges;  ///< by j, then i
  std::vector<int> begin;        ///< of the edges with each j; one more, their end

  void rotations(const std::vector<WideRow>& p, std::vector<WideMatrix>& r) const;
  Vector cellStiffness(const Points& p) const;
  Sparse system(const Vector& stiffness, const Vector& strength) const;
  double energy(const Points& p) const;
};

void Arap::Impl::rotations(const std::vector<WideRow>& p, std::vector<WideMatrix>& r) const {
  r.assign(vertices(), WideMatrix{});
  arapSteps().addCovariances(edges, p, r);
  toNearestRotations(r);
}

/// Weights by which squares act like the Charbonnier function of each vertex's strain, whose scale
/// is the median strain: lengths add up beyond it instead of squares.
Vector Arap::Impl::cellStiffness(const Points& p) const {
  std::vector<WideMatrix> r;
  rotations(wideRows(p), r);
  Vector change = Vector::Zero(vertices()), length = change;
  for (const RigidEdge& e : edges) {
    const Eigen::Vector3d bent = (p.row(e.i) - p.row(e.j)).transpose();
    for (int v : {e.i, e.j}) {
      const Eigen::Vector3d rigid = narrow(r[v]) * e.rest.transpose();
      change[v] += e.weight * (bent - rigid).squaredNorm();
      length[v] += e.weight * rigid.squaredNorm();
    }
  }
  const Vector strain = (length.array() > 0).select(change.cwiseQuotient(length), 0);
  const double typical = median({strain.data(), strain.data() + strain.size()});
  constexpr double RIGID = 1e-12;  // all of it rigid: no strain stands out
  return (1 + strain.array() / std::max(RIGID, typical)).rsqrt();
}

/// The upper triangle of the weights' Laplacian, with each vertex's share of an edge multiplied by
/// its stiffness, and the strength of the goals.
Sparse Arap::Impl::system(const Vector& stiffness, const Vector& strength) const {
  const auto n = vertices();
  Sparse upper(n, n);
  upper.resizeNonZeros(static_cast<Eigen::Index>(edges.size()) + n);
  Vector diagonal = strength;
  Eigen::Index entry = 0;
  for (int j = 0; j < n; ++j) {
    upper.outerIndexPtr()[j] = static_cast<int>(entry);
    for (int k = begin[j]; k < begin[j + 1]; ++k, ++entry) {
      const RigidEdge& e = edges[k];
      const double weight = 0.5 * (stiffness[e.i] + stiffness[e.j]) * e.weight;
      upper.innerIndexPtr()[entry] = e.i;
      upper.valuePtr()[entry] = -weight;
      diagonal[e.i] += weight;
      diagonal[e.j] += weight;
    }
    upper.innerIndexPtr()[entry++] = j;
  }
  upper.outerIndexPtr()[n] = static_cast<int>(entry);
  for (int j = 0; j < n; ++j) upper.valuePtr()[upper.outerIndexPtr()[j + 1] - 1] = diagonal[j];
  return upper;
}

double Arap::Impl::energy(const Points& p) const {
  std::vector<WideMatrix> r;
  rotations(wideRows(p), r);
  double sum = 0;
  for (const RigidEdge& e : edges) {
    const Eigen::Vector3d bent = (p.row(e.i) - p.row(e.j)).transpose();
    for (int v : {e.i, e.j})
      sum += 0.5 * e.weight * (bent - narrow(r[v]) * e.rest.transpose()).squaredNorm();
  }
  return sum / mass.sum();
}

Arap::Arap(const TriangleMesh& rest, const Laplacian& laplacian) {
  const int n = static_cast<int>(rest.vertices.rows());
  require(laplacian.mass.size() == n, "Arap: the Laplacian is of another mesh");
  auto impl = std::make_unique<Impl>();
  Sparse weights = laplacian.stiffness;
  weights.prune([](int row, int column, double value) { return row == column || value < 0; });
  Order inverse;
  Eigen::AMDOrdering<int>()(weights, inverse);
  impl->order = inverse.inverse();
  impl->mass = impl->order * laplacian.mass;
  const Points places = impl->order * rest.vertices;
  const Eigen::VectorXi& at = impl->order.indices();
  for (int column = 0; column < n; ++column)
    for (Sparse::InnerIterator it(weights, column); it; ++it)
      if (const int i = at[it.row()], j = at[column]; i < j)
        impl->edges.push_back({i, j, -it.value(), places.row(i) - places.row(j)});
  std::sort(impl->edges.begin(), impl->edges.end(), [](const auto& a, const auto& b) {
    return std::pair(a.j, a.i) < std::pair(b.j, b.i);
  });
  impl->begin.assign(n + 1, 0);
  for (const RigidEdge& e : impl->edges) ++impl->begin[e.j + 1];
  std::partial_sum(impl->begin.begin(), impl->begin.end(), impl->begin.begin());
  impl_ = std::move(impl);
}

Arap::~Arap() = default;
Arap::Arap(Arap&&) noexcept = default;
Arap& Arap::operator=(Arap&&) noexcept = default;

std::vector<Eigen::Matrix3d> Arap::rotations(const Points& bent) const {
  require(bent.rows() == impl_->vertices(), "Arap: one place a vertex");
  std::vector<WideMatrix> ordered;
  impl_->rotations(wideRows(impl_->order * bent), ordered);
  std::vector<Eigen::Matrix3d> r;
  for (int at : impl_->order.indices()) r.push_back(narrow(ordered[at]));
  return r;
}

/// In the surface's own order.
struct Arap::Attraction::Impl {
  Vector strength;   // of each goal
  Vector stiffness;  // of each vertex's surroundings
  Factors factors;
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
  require(bent.rows() == 0 || bent.rows() == impl_->mass.size(), "Arap: one place a vertex");
  auto attraction = std::make_unique<Attraction::Impl>();
  // A trace of every goal keeps parts that nothing pulls from being singular.
  constexpr double TRACE = 1e-9;
  attraction->strength = softness * impl_->mass;
  if (confidence.size() > 0)
    attraction->strength.array() *= (impl_->order * confidence).array().max(TRACE);
  attraction->stiffness =
      bent.rows() > 0 ? impl_->cellStiffness(impl_->order * bent) : Vector::Ones(impl_->vertices());
  attraction->factors.compute(impl_->system(attraction->stiffness, attraction->strength));
  if (attraction->factors.info() != Eigen::Success)
    throw TornSurface("a surface is too torn to be bent");
  return Attraction(std::move(attraction));
}

Points Arap::pull(const Points& start,
                  const Points& goals,
                  const Attraction& attraction,
                  int iterations) const {
  const auto n = impl_->vertices();
  require(start.rows() == n && goals.rows() == n, "Arap: one place and one goal a vertex");
  require(attraction.impl_->strength.size() == n, "Arap: the attraction is of another surface");
  const Factors& factors = attraction.impl_->factors;
  const Vector inverse_diagonal = factors.vectorD().cwiseInverse();
  const Points strong = attraction.impl_->strength.asDiagonal() * (impl_->order * goals);
  const std::vector<WideRow> pull = wideRows(strong);
  std::vector<WideRow> places = wideRows(impl_->order * start);
  std::vector<WideMatrix> r;
  for (int i = 0; i < iterations; ++i) {
    impl_->rotations(places, r);
    places = pull;
    arapSteps().addRigidPull(impl_->edges, r, attraction.impl_->stiffness, places);
    arapSteps().solve(factors.matrixL().nestedExpression(), inverse_diagonal, places);
  }
  return impl_->order.transpose() * narrowRows(places);
}

double Arap::energy(const Points& bent) const {
  require(bent.rows() == impl_->vertices(), "Arap: one place a vertex");
  return impl_->energy(impl_->order * bent);
}

}  // namespace posture
