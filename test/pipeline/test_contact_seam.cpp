// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/handles.h>

#include <gtest/gtest.h>

#include "pipeline/tube.h"
#include "sides/contact_seam.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace posture {
namespace {

using test::ACROSS;
using test::AROUND;
using test::PI;
using test::tube;

/// Slowly narrower towards pi, where it has 0.4 of its thickness, and with a fold at 0, where it
/// has 0.6: as an arm whose hand has grown together with something.
double armAndFold(double angle) {
  const double along = std::abs(angle);
  return std::min(1 - 0.6 * std::pow(along / PI, 2), 0.6 + 2.5 * along);
}

std::vector<int> ringAt(int around) {
  std::vector<int> ring(ACROSS);
  for (int j = 0; j < ACROSS; ++j) ring[j] = around * ACROSS + j;
  return ring;
}

double lengthOf(const TriangleMesh& mesh, const std::vector<int>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += (mesh.vertices.row(ring[i]) - mesh.vertices.row(ring[(i + 1) % ring.size()])).norm();
  return sum;
}

using Seam = std::vector<std::pair<int, int>>;

std::vector<int> verticesOf(const Seam& seam) {
  std::set<int> vertices;
  for (const auto& [a, b] : seam) vertices.insert({a, b});
  return {vertices.begin(), vertices.end()};
}

int handlesWithout(const TriangleMesh& mesh, const std::vector<int>& vertices) {
  Faces left(mesh.faces.rows(), 3);
  int count = 0;
  for (const auto& face : mesh.faces.rowwise())
    if (std::none_of(
            vertices.begin(), vertices.end(), [&](int v) { return (face.array() == v).any(); }))
      left.row(count++) = face;
  return Handles({mesh.vertices, left.topRows(count)}).count();
}

TEST(ContactSeam, isInTheFoldNotWhereTheTubeIsNarrowest) {
  const TriangleMesh mesh = tube(armAndFold);
  const std::vector<int> narrowest = ringAt(AROUND / 2);
  ASSERT_LT(lengthOf(mesh, narrowest), 0.8 * lengthOf(mesh, ringAt(0)));
  const std::vector<int> seam = verticesOf(contactSeam(mesh, narrowest));
  for (int v : seam) {
    const int steps = v / ACROSS;
    EXPECT_LE(std::min(steps, AROUND - steps), 2);
  }
  EXPECT_EQ(Handles(mesh).count(), 1);
  EXPECT_EQ(handlesWithout(mesh, seam), 0);
}

TEST(ContactSeam, isTheSameFromWhereverTheRingIs) {
  const TriangleMesh mesh = tube(armAndFold);
  const std::vector<int> seam = verticesOf(contactSeam(mesh, ringAt(AROUND / 2)));
  EXPECT_EQ(verticesOf(contactSeam(mesh, ringAt(AROUND / 4))), seam);
  std::vector<int> other_way = ringAt(AROUND / 3);
  std::reverse(other_way.begin(), other_way.end());
  EXPECT_EQ(verticesOf(contactSeam(mesh, other_way)), seam);
}

TEST(ContactSeam, isTheRingWhereNoPathIsCheaper) {
  // The tube is narrowest and folds inwards at 0.
  const TriangleMesh mesh = tube([](double angle) { return 0.4 + std::abs(angle) / PI; });
  const std::vector<int> ring = ringAt(0);
  EXPECT_EQ(verticesOf(contactSeam(mesh, ring)), ring);
}

TEST(ContactSeam, doesNotCountWaysThereAndBack) {
  const TriangleMesh mesh = tube(armAndFold);
  const std::vector<int> ring = ringAt(AROUND / 2);
  std::vector<int> with_spur = ring;
  const int off = ring.front() + ACROSS;
  with_spur.insert(with_spur.begin() + 1, {off, off, ring.front()});
  EXPECT_EQ(contactSeam(mesh, with_spur), contactSeam(mesh, ring));
}

TEST(ContactSeam, passesAHoleInTheFold) {
  // Of the fold half was not seen: it still opens the handle, with fewer vertices.
  TriangleMesh mesh = tube(armAndFold);
  const std::size_t whole = contactSeam(mesh, ringAt(AROUND / 2)).size();
  Faces left(mesh.faces.rows(), 3);
  int count = 0;
  for (const auto& face : mesh.faces.rowwise()) {
    const Eigen::RowVector3d middle = mesh.vertices(face.reshaped(), Eigen::all).colwise().mean();
    if (!(middle.x() > 0 && std::abs(middle.y()) < 0.12 && middle.z() > 0))
      left.row(count++) = face;
  }
  mesh.faces = left.topRows(count);
  const Seam seam = contactSeam(mesh, ringAt(AROUND / 2));
  EXPECT_LT(seam.size(), 0.7 * whole);
  EXPECT_EQ(handlesWithout(mesh, verticesOf(seam)), 0);
}

}  // namespace
}  // namespace posture
