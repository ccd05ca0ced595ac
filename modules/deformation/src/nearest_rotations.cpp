// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nearest_rotations.h"

#include <posture/mesh/nearest_rotation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace posture {
namespace {

/// Matrices that go through the same steps side by side, entry by entry.
constexpr int LANES = 8;
using Lane = Eigen::Array<double, LANES, 1>;
struct Lanes {
  Lane at[3][3];
};

Lane squaredNorm(const Lanes& m) {
  Lane sum = Lane::Zero();
  for (const auto& row : m.at)
    for (const Lane& entry : row) sum += entry.square();
  return sum;
}

Lanes cofactors(const Lanes& m) {
  Lanes c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int a = (i + 1) % 3, b = (i + 2) % 3, x = (j + 1) % 3, y = (j + 2) % 3;
      c.at[i][j] = m.at[a][x] * m.at[b][y] - m.at[a][y] * m.at[b][x];
    }
  return c;
}

/// Given the cofactors c of m.
Lane determinant(const Lanes& m, const Lanes& c) {
  return m.at[0][0] * c.at[0][0] + m.at[0][1] * c.at[0][1] + m.at[0][2] * c.at[0][2];
}

/// M = R P with P symmetric. With M of norm 1, the trace t of P is the largest root of a quartic in
/// the invariants of M (Horn 1987; Theobald 2005), and by Cayley and Hamilton
/// (M M' + I2 1) R = cof M + t M, with I2 = (t^2 - 1) / 2.
/// \return  whether each rotation is the only one as good, as far as rounding lets one tell.
Eigen::Array<bool, LANES, 1> nearestRotations(const Lanes& given, Lanes& rotations) {
  constexpr int MAX_STEPS = 30;
  // The rotation comes of a division by what AMBIGUOUS bounds: far above rounding, far below what
  // surfaces that bend have.
  constexpr double CONVERGED = 1e-14, AMBIGUOUS = 1e-4;
  const Lane scale = squaredNorm(given).rsqrt();
  Lanes m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m.at[i][j] = scale * given.at[i][j];
  const Lanes c = cofactors(m);
  const Lane det = determinant(m, c), squared = squaredNorm(c), constant = 1 - 4 * squared;
  // From above, where Newton's steps never pass the root: I2^2 = |cof M|^2 + 2 det M t, with t from
  // 1 to sqrt(3) where I2 >= 0; elsewhere the root is below 1 and the start is not. Close to it
  // where a surface is nearly flat.
  const Lane most = (squared + 2 * det.max(std::sqrt(3.0) * det)).max(0).sqrt();
  Lane t = (1 + 2 * most).sqrt();
  // The slope falls on the way down, to 8 times the product of the sums of two singular values
  // each: where that vanishes roots meet, and steps are noise. False for what is no number.
  Eigen::Array<bool, LANES, 1> clear = Eigen::Array<bool, LANES, 1>::Constant(true);
  for (int step = 0; step < MAX_STEPS; ++step) {
    const Lane value = ((t * t - 2) * t - 8 * det) * t + constant;
    const Lane slope = 4 * ((t * t - 1) * t - 2 * det);
    clear = clear && slope > 8 * AMBIGUOUS;
    const Lane change = clear.select(value / slope, 0);
    t -= change;
    if (!(change > CONVERGED).any()) break;
  }
  const Lane second = 0.5 * (t * t - 1);
  Lanes system;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      system.at[i][j] = system.at[j][i] =
          m.at[i][0] * m.at[j][0] + m.at[i][1] * m.at[j][1] + m.at[i][2] * m.at[j][2];
  for (int i = 0; i < 3; ++i) system.at[i][i] += second;
  const Lanes adjugate = cofactors(system);  // symmetric as the system is
  const Lane inverse = determinant(system, adjugate).inverse();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Lane sum = Lane::Zero();
      for (int k = 0; k < 3; ++k) sum += adjugate.at[i][k] * (c.at[k][j] + t * m.at[k][j]);
      rotations.at[i][j] = inverse * sum;
    }
  return clear && t * second - det > AMBIGUOUS;
}

}  // namespace

void toNearestRotations(std::vector<WideMatrix>& matrices) {
  Lanes given, rotations;
  for (std::size_t first = 0; first < matrices.size(); first += LANES) {
    const int count = static_cast<int>(std::min<std::size_t>(LANES, matrices.size() - first));
    // The last matrix fills the lanes left over.
    for (int lane = 0; lane < LANES; ++lane)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          given.at[i][j][lane] = matrices[first + std::min(lane, count - 1)].column[j].at[i];
    const auto clear = nearestRotations(given, rotations);
    for (int lane = 0; lane < count; ++lane) {
      WideMatrix& matrix = matrices[first + lane];
      if (!clear[lane]) {
        matrix = wide(nearestRotation(narrow(matrix)));
        continue;
      }
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) matrix.column[j].at[i] = rotations.at[i][j][lane];
    }
  }
}

}  // namespace posture
