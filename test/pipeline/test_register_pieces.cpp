// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/pipeline/register_shapes.h>

#include <gtest/gtest.h>

#include "pipeline/divided.h"
#include "support/bodies.h"
#include <string>

namespace posture {
namespace {

using test::divided;
using test::person;

/// A person in one pose and in another, either of which may be in pieces; most of it has to find
/// its place.
RegistrationResult registeredWhole(const ArticulatedBody& body,
                                   const TriangleMesh& source,
                                   const ArticulatedBody& other,
                                   const TriangleMesh& target) {
  RegistrationResult result = registerShapes(source, target);
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  EXPECT_GE(result.target.joined_pieces, 1);
  EXPECT_EQ(result.source.faces, source.faces.rows());
  double sum = 0;
  int count = 0;
  for (const VertexPair& pair : groundTruth(body, other)) {
    const SurfacePoint& place = result.correspondence.on_target[pair.source];
    EXPECT_LT(place.face, target.faces.rows());
    if (place.vertex < 0) continue;
    sum += (target.vertices.row(place.vertex) - target.vertices.row(pair.target)).norm();
    ++count;
  }
  EXPECT_GT(count, 0.95 * static_cast<double>(source.vertices.rows()));
  EXPECT_LT(sum / count, 0.02);
  return result;
}

/// Divided in one pose and another way in the other.
void expectRegisteredWhole(double source_share, double target_share) {
  const ArticulatedBody body = person(0, 0), other = person(1, 1);
  const RegistrationResult result = registeredWhole(
      body, divided(body.mesh, source_share), other, divided(other.mesh, target_share));
  EXPECT_GE(result.source.joined_pieces, 1);
}

TEST(RegisterShapes, aBodyInPiecesIsRegisteredWithThemJoined) {
  // The largest piece of the one is all above the hips, that of the other all below the shoulders.
  expectRegisteredWhole(0.5, 0.7);
}

TEST(RegisterShapes, piecesAreJoinedWhereTheMainSurfacesLeaveThemOut) {
  // The largest pieces, from hips and from knees up, convince without the legs.
  expectRegisteredWhole(0.5, 0.25);
}

/// The faces that a bone shares with others taken away.
TriangleMesh severed(const ArticulatedBody& body, const std::string& bone) {
  const auto belongs = [&](int v) { return body.bone_names[body.bone[v]] == bone; };
  TriangleMesh mesh = body.mesh;
  int kept = 0;
  for (const auto& f : body.mesh.faces.rowwise())
    if (belongs(f[0]) == belongs(f[1]) && belongs(f[0]) == belongs(f[2]))
      mesh.faces.row(kept++) = f;
  mesh.faces.conservativeResize(kept, 3);
  return mesh;
}

TEST(RegisterShapes, aPieceOfTheTargetIsJoinedForWhatIsOneOnTheSource) {
  const ArticulatedBody body = person(0, 0), other = person(1, 1);
  const RegistrationResult result =
      registeredWhole(body, body.mesh, other, severed(other, "foot_l"));
  EXPECT_EQ(result.target.joined_pieces, 1);
}

}  // namespace
}  // namespace posture
