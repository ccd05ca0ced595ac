// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/edge_paths.h>
#include <posture/mesh/handles.h>

#include <gtest/gtest.h>

#include "pipeline/grown_together.h"
#include "pipeline/tube.h"
#include "sides/contacts.h"
#include "support/bodies.h"
#include "support/cpu_seconds.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

using test::Contact;
using test::Fused;
using test::grownTogether;
using test::person;

TEST(PartedSurface, leavesABodyWithoutHandlesAsItIs) {
  const TriangleMesh mesh = person(3).mesh;
  const CleanMesh clean = cleanMesh(mesh);
  const PartedSurface parted = partedSurface(mesh, clean);
  EXPECT_EQ(parted.contacts, 0);
  EXPECT_EQ(parted.clean.mesh.faces, clean.mesh.faces);
}

class PartedContact : public testing::TestWithParam<Contact> {};
INSTANTIATE_TEST_SUITE_P(PartedSurface,
                         PartedContact,
                         testing::Values(Contact::TUBE, Contact::VERTEX));

TEST_P(PartedContact, givesTheDistancesBackThatItShortened) {
  const ArticulatedBody body = person(3);
  const Fused fused = grownTogether(body, GetParam());
  const CleanMesh clean = cleanMesh(fused.mesh);
  const PartedSurface parted = partedSurface(fused.mesh, clean);
  EXPECT_EQ(parted.contacts, 1);
  EXPECT_EQ(Handles(parted.clean.mesh).count(), 0);
  // Of the clean mesh little is lost,
  int lost = 0;
  for (int v = 0; v < clean.offset.size(); ++v) lost += parted.clean.offset[v] > 0;
  EXPECT_LT(lost, 0.02 * clean.offset.size());
  // and beside the contact the way to the other side is that of the body.
  const auto lengthBeside = [&](const CleanMesh& mesh) {
    const auto beside = [&](int center) {
      int best = -1;
      double nearest = 1e9;
      for (int v = 0; v < body.mesh.vertices.rows(); ++v) {
        const double d = (body.mesh.vertices.row(v) - body.mesh.vertices.row(center)).norm();
        if (parted.clean.offset[v] == 0 && clean.offset[v] == 0 && d < nearest) {
          nearest = d;
          best = mesh.clean_vertex[v];
        }
      }
      return best;
    };
    return EdgePaths(mesh.mesh).lengths({beside(fused.a)})[beside(fused.b)];
  };
  const double true_length = EdgePaths(body.mesh).lengths({fused.a})[fused.b];
  EXPECT_LT(lengthBeside(clean), 0.6 * true_length);
  EXPECT_GT(lengthBeside(parted.clean), 0.8 * true_length);
}

TEST(PartedSurface, leavesSmallHandlesAlone) {
  // Two neighbouring places of a sphere grown together: the way around is short.
  const TriangleMesh ball = test::sphere(4);
  const TriangleMesh mesh = test::fused(ball, 700, [&] {
    int at = -1;
    double best = 1e9;
    for (int v = 0; v < ball.vertices.rows(); ++v) {
      const double d = (ball.vertices.row(v) - ball.vertices.row(700)).norm();
      if (d > 0.25 && d < best) {
        best = d;
        at = v;
      }
    }
    return at;
  }());
  ASSERT_EQ(Handles(cleanMesh(mesh).mesh).count(), 1);
  EXPECT_EQ(partedSurface(mesh, cleanMesh(mesh)).contacts, 0);
}

TEST(PartedSurface, isCutInARoundedFoldHoweverFineTheMesh) {
  // A fold as wide as 0.2 radians around, and a narrower arm.
  const auto rounded = [](double angle) {
    const double along = std::abs(angle), round = std::sqrt(along * along + 0.01);
    return std::min(1 - 0.65 * std::pow(along / test::PI, 2), 0.35 + 2.5 * round);
  };
  for (int times : {1, 5}) {
    const TriangleMesh mesh = test::tube(rounded, times * test::AROUND, times * test::ACROSS);
    const PartedSurface parted = partedSurface(mesh, cleanMesh(mesh));
    EXPECT_EQ(parted.contacts, 1) << times;
    for (int f = 0; f < mesh.faces.rows(); ++f)
      if (parted.gone[f] != 0) {
        const auto vertex = mesh.vertices.row(mesh.faces(f, 0));
        ASSERT_LT(std::abs(std::atan2(vertex.y(), vertex.x())), 0.3) << times;
      }
  }
}

/// A plate of cells x cells, with holes right through it: a handle each.
TriangleMesh plateWithHoles(int cells, int holes) {
  TriangleMesh mesh;
  const int side = cells + 1;
  mesh.vertices.resize(2 * side * side, 3);
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    const int layer = v / (side * side);
    mesh.vertices.row(v) << v % side, v / side % side, layer;
  }
  std::vector<char> open(cells * cells, 0);
  for (int i = 1, made = 0; i < cells - 1; i += 3)
    for (int j = 1; j < cells - 1 && made < holes; j += 3, ++made) open[i * cells + j] = 1;
  std::vector<Eigen::RowVector3i> faces;
  const auto quad = [&](int a, int b, int c, int d) {
    faces.emplace_back(a, b, c);
    faces.emplace_back(a, c, d);
  };
  const auto isSolid = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < cells && j < cells && !open[i * cells + j];
  };
  const int up = side * side;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      if (!isSolid(i, j)) continue;
      const int a = i * side + j, b = a + 1, c = b + side, d = a + side;
      quad(a + up, b + up, c + up, d + up);
      quad(d, c, b, a);
      if (!isSolid(i - 1, j)) quad(a, b, b + up, a + up);
      if (!isSolid(i, j + 1)) quad(b, c, c + up, b + up);
      if (!isSolid(i + 1, j)) quad(c, d, d + up, c + up);
      if (!isSolid(i, j - 1)) quad(d, a, a + up, d + up);
    }
  mesh.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
    mesh.faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  return mesh;
}

TEST(PartedSurface, takesLittleLongerForManySmallHandles) {
  const auto secondsFor = [](int holes) {
    const TriangleMesh mesh = plateWithHoles(45, holes);
    const CleanMesh clean = cleanMesh(mesh);
    EXPECT_EQ(Handles(clean.mesh).count(), holes);
    return test::cpuSeconds([&] { EXPECT_EQ(partedSurface(mesh, clean).contacts, 0); });
  };
  const double few = secondsFor(8);
  EXPECT_LT(secondsFor(200), 5 * few);
}

}  // namespace
}  // namespace posture
