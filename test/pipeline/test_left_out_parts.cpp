// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "outcome/left_out_parts.h"
#include "support/shapes.h"
#include <vector>

namespace posture {
namespace {

/// Spheres of these radii beside each other, of 162 vertices each.
TriangleMesh spheres(const std::vector<double>& radii) {
  const TriangleMesh ball = test::sphere(2);
  TriangleMesh mesh{Points(0, 3), Faces(0, 3)};
  for (std::size_t k = 0; k < radii.size(); ++k)
    mesh = test::joined(mesh,
                        test::shifted({radii[k] * ball.vertices, ball.faces},
                                      {3.0 * static_cast<double>(k), 0, 0}));
  return mesh;
}

/// Registered with what leads the first `mapped` vertices of the source to those of their number.
RegistrationResult mapped(const TriangleMesh& source, const TriangleMesh& target, int mapped) {
  const CleanMesh clean_source = cleanMesh(source), clean_target = cleanMesh(target);
  RegistrationResult result;
  result.status = Status::REGISTERED;
  result.correspondence.on_target.resize(source.vertices.rows());
  for (int v = 0; v < mapped; ++v) result.correspondence.on_target[v].vertex = v;
  noteLeftOutParts({source, clean_source}, {target, clean_target}, result);
  return result;
}

TEST(LeftOutParts, areTheLargestOtherOnesThatTheMapDoesNotReach) {
  const TriangleMesh two = spheres({1, 0.9}), three = spheres({1, 0.3, 0.6});
  RegistrationResult result = mapped(two, three, 162);
  EXPECT_NEAR(result.source.left_out_share, 0.81, 1e-6);
  EXPECT_NEAR(result.target.left_out_share, 0.36, 1e-6);
  // Of the target the smaller one is reached as well.
  result = mapped(two, three, 324);
  EXPECT_EQ(result.source.left_out_share, 0);
  EXPECT_NEAR(result.target.left_out_share, 0.36, 1e-6);
}

TEST(LeftOutParts, thereAreNoneOfOneSurface) {
  const RegistrationResult result = mapped(spheres({1}), spheres({1}), 100);
  EXPECT_EQ(result.source.left_out_share, 0);
  EXPECT_EQ(result.target.left_out_share, 0);
}

TEST(LeftOutParts, placesInAFaceReachItsCorners) {
  // A source of one vertex on the other sphere is coarser than that.
  const TriangleMesh one = spheres({1}), two = spheres({1, 0.9});
  const CleanMesh clean_one = cleanMesh(one), clean_two = cleanMesh(two);
  RegistrationResult result;
  result.correspondence.on_target.resize(162);
  const auto half = two.faces.rows() / 2;
  for (int k = 0; k < 10; ++k) {
    const int face = static_cast<int>(half) + 7 * k;
    result.correspondence.on_target[k] = {two.faces(face, 0), face, Eigen::Vector3d(1, 0, 0)};
  }
  noteLeftOutParts({one, clean_one}, {two, clean_two}, result);
  EXPECT_EQ(result.target.left_out_share, 0);
}

TEST(LeftOutParts, ofASoupTheCornersAtAPlaceAreOne) {
  const TriangleMesh one = spheres({1}), soup = test::soup(spheres({1, 0.9}));
  const CleanMesh clean_one = cleanMesh(one), clean_soup = cleanMesh(soup);
  RegistrationResult result;
  result.correspondence.on_target.resize(162);
  // The last faces, whose corners are at places of earlier ones.
  for (int k = 0; k < 10; ++k) {
    const int face = static_cast<int>(soup.faces.rows()) - 1 - k;
    result.correspondence.on_target[k] = {soup.faces(face, 0), face, Eigen::Vector3d(1, 0, 0)};
  }
  noteLeftOutParts({one, clean_one}, {soup, clean_soup}, result);
  EXPECT_EQ(result.target.left_out_share, 0);
}

}  // namespace
}  // namespace posture
