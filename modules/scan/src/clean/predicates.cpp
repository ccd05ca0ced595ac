// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/predicates.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace posture {
namespace {

/// Holds sums of products of five differences.
using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<320,
                                           320,
                                           boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           void>>;

template <class T>
using Triple = std::array<T, 3>;

/// Without rounding, in either type.
template <class T>
Triple<T> difference(const LatticePoint& a, const LatticePoint& b) {
  Triple<T> result;
  for (int k = 0; k < 3; ++k) result[k] = T(static_cast<std::int64_t>(a[k] - b[k]));
  return result;
}

template <>
Triple<double> difference(const LatticePoint& a, const LatticePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class T>
T determinant(const Triple<T>& a, const Triple<T>& b, const Triple<T>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

template <class T>
T squaredNorm(const Triple<T>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

double largest(const Triple<double>& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

template <class T>
int sign(const T& value) {
  return (value > 0) - (value < 0);
}

/// The determinant of four differences and their squares.
template <class T>
T inSphere(const std::array<Triple<T>, 4>& v) {
  return squaredNorm(v[0]) * determinant(v[1], v[2], v[3]) -
         squaredNorm(v[1]) * determinant(v[0], v[2], v[3]) +
         squaredNorm(v[2]) * determinant(v[0], v[1], v[3]) -
         squaredNorm(v[3]) * determinant(v[0], v[1], v[2]);
}

template <class T>
std::array<Triple<T>, 4> differences(const std::array<const LatticePoint*, 4>& corners,
                                     const LatticePoint& e) {
  return {difference<T>(*corners[0], e),
          difference<T>(*corners[1], e),
          difference<T>(*corners[2], e),
          difference<T>(*corners[3], e)};
}

int sideOfSphere(const std::array<const LatticePoint*, 4>& corners, const LatticePoint& e) {
  const auto v = differences<double>(corners, e);
  const double value = inSphere(v);
  const std::array<double, 4> size{largest(v[0]), largest(v[1]), largest(v[2]), largest(v[3])};
  const double largest_size = *std::max_element(size.begin(), size.end());
  // 24 products with a square of at most 3 size^2, ten roundings each: below 2000 units of 2^-53.
  if (std::abs(value) > 3e-13 * largest_size * size[0] * size[1] * size[2] * size[3])
    return sign(value);
  return sign(inSphere(differences<Exact>(corners, e)));
}

}  // namespace

int orientation(const LatticePoint& a,
                const LatticePoint& b,
                const LatticePoint& c,
                const LatticePoint& d) {
  const auto x = difference<double>(b, a), y = difference<double>(c, a),
             z = difference<double>(d, a);
  const double value = determinant(x, y, z);
  // Six products of three, five roundings each.
  if (std::abs(value) > 1e-14 * largest(x) * largest(y) * largest(z)) return sign(value);
  return sign(
      determinant(difference<Exact>(b, a), difference<Exact>(c, a), difference<Exact>(d, a)));
}

bool isInSphere(const LatticePoint& a,
                const LatticePoint& b,
                const LatticePoint& c,
                const LatticePoint& d,
                const LatticePoint& e) {
  const std::array<const LatticePoint*, 4> corners{&a, &b, &c, &d};
  if (const int side = sideOfSphere(corners, e)) return side > 0;
  std::array<const LatticePoint*, 5> sorted{&a, &b, &c, &d, &e};
  std::sort(sorted.begin(), sorted.end(), [](const LatticePoint* p, const LatticePoint* q) {
    return *p < *q;
  });
  // The last in order is moved most, away from the centre: the others then decide.
  for (int i = 4; i > 2; --i) {
    if (sorted[i] == &e) return false;
    std::array<const LatticePoint*, 4> others = corners;
    *std::find(others.begin(), others.end(), sorted[i]) = &e;
    if (const int side = orientation(*others[0], *others[1], *others[2], *others[3]))
      return side > 0;
  }
  return false;
}

}  // namespace posture
