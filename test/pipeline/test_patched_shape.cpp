// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/handles.h>
#include <posture/mesh/normals.h>
#include <posture/pipeline/register_shapes.h>

#include <gtest/gtest.h>

#include "attempts/leave_out_patches.h"
#include "sides/given_shape.h"
#include "sides/patched_shape.h"
#include "support/bodies.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

using test::person;

/// Divided in two or more by a narrow gap across z, at a share of the height.
TriangleMesh divided(TriangleMesh mesh, double share) {
  const double low = mesh.vertices.col(2).minCoeff(), high = mesh.vertices.col(2).maxCoeff();
  const double z = low + share * (high - low), half = 0.01 * (high - low);
  int kept = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    bool inside = false;
    for (int k = 0; k < 3; ++k)
      inside = inside || std::abs(mesh.vertices(mesh.faces(f, k), 2) - z) < half;
    if (!inside) mesh.faces.row(kept++) = mesh.faces.row(f).eval();
  }
  mesh.faces.conservativeResize(kept, 3);
  return mesh;
}

TEST(WithBridges, joinsThePiecesOfABodyAndKeepsWhatWasGiven) {
  const TriangleMesh apart = divided(person(0, 0).mesh, 0.5);
  const CleanMesh clean = cleanMesh(apart);
  ASSERT_EQ(clean.summary.components, 2);
  const PatchedShape joined = withBridges(apart, clean);
  EXPECT_EQ(joined.pieces, 1);
  EXPECT_EQ(joined.vertices, 0);
  EXPECT_EQ(joined.input.vertices, apart.vertices);
  ASSERT_GT(joined.input.faces.rows(), apart.faces.rows());
  EXPECT_EQ(joined.input.faces.topRows(apart.faces.rows()), apart.faces);
  EXPECT_EQ(joined.clean.summary.components, 1);
  EXPECT_EQ(joined.clean.pieces.faces.rows(), 0);
  EXPECT_EQ(joined.clean.summary.flipped_faces, 0);
}

TEST(WithBridges, leavesOneSurfaceAsItIs) {
  const TriangleMesh whole = person(0, 0).mesh;
  const PatchedShape same = withBridges(whole, cleanMesh(whole));
  EXPECT_EQ(same.pieces, 0);
  EXPECT_EQ(same.input.faces, whole.faces);
}

TEST(WithPatches, doesNotTurnASurfaceRoundThatItCloses) {
  // Inside out and left so; its own shape tells.
  TriangleMesh ball = test::sphere(4);
  int kept = 0;
  for (int f = 0; f < ball.faces.rows(); ++f)
    if (ball.vertices(ball.faces(f, 0), 2) < 0.97)
      ball.faces.row(kept++) = ball.faces.row(f).eval();
  ball.faces.conservativeResize(kept, 3);
  ball.faces.col(0).swap(ball.faces.col(1));
  const CleanMesh clean = cleanMesh(ball, Facing::AS_MOST);
  const PatchedShape patched = withPatches(ball, clean);
  ASSERT_EQ(patched.holes, 1);
  const Points before = vertexNormals(clean.mesh), after = vertexNormals(patched.clean.mesh);
  for (int v = 0; v < before.rows(); ++v)
    EXPECT_GT(before.row(v).dot(after.row(patched.clean.clean_vertex[clean.input_vertex[v]])), 0.5);
}

TEST(WithPatches, closesWhatIsCutOpenAtAContact) {
  const TriangleMesh mesh = test::torus(80, 20, 1, 0.2);
  const CleanMesh clean = cleanMesh(mesh);
  const PartedSurface parted = partedSurface(mesh, clean);
  ASSERT_EQ(parted.contacts, 1);
  const PatchedShape patched = withPatches(mesh, parted);
  EXPECT_EQ(patched.holes, 2);
  EXPECT_EQ(patched.contacts, 1);
  EXPECT_EQ(Handles(patched.clean.mesh).count(), 0);
  const HalfEdgeMesh edges(patched.clean.mesh.faces,
                           static_cast<int>(patched.clean.mesh.vertices.rows()));
  EXPECT_TRUE(edges.boundaryLoops().empty());
  // What was given keeps its number, but for the faces along the contact.
  ASSERT_GT(patched.input.faces.rows(), mesh.faces.rows());
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3i face = patched.input.faces.row(f);
    if (parted.gone[f] != 0)
      EXPECT_TRUE((face.array() == mesh.faces(f, 0)).all()) << f;
    else
      EXPECT_EQ(face, mesh.faces.row(f)) << f;
  }
  EXPECT_EQ(patched.input.vertices.topRows(mesh.vertices.rows()), mesh.vertices);
}

TEST(LeaveOutPatches, whatLiesBesideTheRimGoesToItAndTheRestHasNoCounterpart) {
  const TriangleMesh whole = test::sphere(5);
  TriangleMesh open = whole;
  int kept = 0;
  for (const auto& f : whole.faces.rowwise())
    if (whole.vertices(f[0], 2) < 0.97) open.faces.row(kept++) = f;
  open.faces.conservativeResize(kept, 3);
  const CleanMesh whole_clean = cleanMesh(whole), open_clean = cleanMesh(open);
  const GivenShape source{whole, whole_clean}, target{open, open_clean};
  const PatchedShape source_patched{whole, whole_clean},
      target_patched = withPatches(open, open_clean);
  ASSERT_EQ(target_patched.holes, 1);
  const int n = static_cast<int>(open.vertices.rows());
  // One source vertex to each of the patch.
  RegistrationResult result;
  result.correspondence.on_target.resize(whole.vertices.rows());
  result.correspondence.confidence = Vector::Ones(whole.vertices.rows());
  result.deformed = whole.vertices;
  for (int i = 0; i < target_patched.vertices; ++i)
    result.correspondence.on_target[i].vertex = n + i;
  leaveOutPatches(source, source_patched, target, target_patched, result);
  const std::vector<char> on_rim = boundaryVertices(open.faces, n);
  int beside = 0, within = 0;
  for (int i = 0; i < target_patched.vertices; ++i) {
    double gap = 10;
    for (int v = 0; v < n; ++v)
      if (on_rim[v])
        gap =
            std::min(gap, (open.vertices.row(v) - target_patched.input.vertices.row(n + i)).norm());
    const int vertex = result.correspondence.on_target[i].vertex;
    // Edges are 0.03 to 0.04 long, 0.015 square roots of the area are 0.053.
    if (gap < 0.05) {
      ++beside;
      ASSERT_GE(vertex, 0);
      EXPECT_TRUE(on_rim[vertex]);
    } else if (gap > 0.06) {
      ++within;
      EXPECT_LT(vertex, 0);
      EXPECT_EQ(result.correspondence.confidence[i], 0);
    }
  }
  EXPECT_GT(beside, 20);
  EXPECT_GT(within, 20);
}

TEST(LeaveOutPatches, onAWideStripOnlyWhatIsBesideAVertexHasACounterpart) {
  // Two squares of surface and a strip of two long faces between them.
  const TriangleMesh square = test::grid(10, 10, 1, 1);
  const TriangleMesh two = test::joined(square, test::shifted(square, {1.5, 0, 0}));
  const CleanMesh clean = cleanMesh(two);
  const auto at = [&](double x, double y) {
    Eigen::Index nearest = 0;
    (two.vertices.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  };
  PatchedShape joined{two, clean};
  joined.pieces = 1;
  const auto strip = two.faces.rows();
  joined.input.faces.conservativeResize(strip + 1, 3);
  joined.input.faces.row(strip) << at(1, 0), at(1.5, 0), at(1, 0.1);
  const PatchedShape as_given{two, clean};
  RegistrationResult result;
  result.correspondence.on_target.resize(two.vertices.rows());
  result.correspondence.confidence = Vector::Ones(two.vertices.rows());
  result.deformed = two.vertices;
  const auto face = static_cast<int>(strip);
  result.correspondence.on_target[0] = {at(1, 0), face, Eigen::Vector3d(0.9, 0.1, 0)};
  result.correspondence.on_target[1] = {at(1, 0), face, Eigen::Vector3d(0.6, 0.4, 0)};
  leaveOutPatches({two, clean}, as_given, {two, clean}, joined, result);
  EXPECT_EQ(result.correspondence.on_target[0].vertex, at(1, 0));
  EXPECT_LT(result.correspondence.on_target[0].face, face);
  EXPECT_LT(result.correspondence.on_target[1].vertex, 0);
  EXPECT_EQ(result.correspondence.confidence[1], 0);
}

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
