// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "refined/work/refined_shape.h"
#include "support/files.h"
#include "support/shapes.h"
#include <algorithm>
#include <array>
#include <vector>

namespace posture {
namespace {

/// All faces of the tetrahedra that fill a block: none of its inner edges has two.
TriangleMesh filledBlock(int side) {
  TriangleMesh mesh;
  mesh.vertices.resize(side * side * side, 3);
  const auto number = [&](const std::array<int, 3>& at) {
    return (at[0] * side + at[1]) * side + at[2];
  };
  std::vector<std::array<int, 3>> faces;
  std::array<int, 3> at{};
  for (at[0] = 0; at[0] < side; ++at[0])
    for (at[1] = 0; at[1] < side; ++at[1])
      for (at[2] = 0; at[2] < side; ++at[2]) {
        mesh.vertices.row(number(at)) << at[0], at[1], at[2];
        if (*std::max_element(at.begin(), at.end()) == side - 1) continue;
        std::array<int, 3> axes{0, 1, 2};
        do {
          std::array<int, 3> corner = at;
          std::array<int, 4> tetrahedron{number(at)};
          for (int k = 0; k < 3; ++k) {
            ++corner[axes[k]];
            tetrahedron[k + 1] = number(corner);
          }
          for (int left_out = 0; left_out < 4; ++left_out) {
            std::array<int, 3> face{};
            for (int k = 0; k < 3; ++k) face[k] = tetrahedron[k + (k >= left_out ? 1 : 0)];
            faces.push_back(face);
          }
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  mesh.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
    mesh.faces.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
  return mesh;
}

TEST(ReduceSide, refusesWhatFallsApartOnFewerVertices) {
  RefinedShape shape = fullSide("target", filledBlock(18), false);
  EXPECT_EQ(test::inputErrorOf([&] { reduceSide("target", 5000, shape); }),
            "target is no surface: hardly any of its faces lie side by side in twos");
}

TEST(FullSide, refusesWhatHasTooFewVertices) {
  EXPECT_EQ(test::inputErrorOf([&] { fullSide("source", test::sphere(0), false); }),
            "source has only 12 usable vertices: too few to tell a shape");
}

TEST(ReduceSide, workMeshesShareABudget) {
  RefinedShape light = fullSide("light", test::sphere(3), false),
               fine = fullSide("fine", test::sphere(5), false);
  reduceSide("source", 10242, light);
  reduceSide("source", 642, fine);
  EXPECT_EQ(light.work.mesh.vertices.rows(), 642);
  EXPECT_EQ(fine.work.mesh.vertices.rows(), 10000);
  reduceSide("source", 4000, fine);
  EXPECT_EQ(fine.work.mesh.vertices.rows(), 6250);
  reduceSide("source", 10242, fine);
  EXPECT_EQ(fine.work.mesh.vertices.rows(), 5000);
  EXPECT_EQ(fine.coarse.mesh.vertices.rows(), 1500);
}

}  // namespace
}  // namespace posture
