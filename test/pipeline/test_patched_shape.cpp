// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/handles.h>
#include <posture/mesh/normals.h>

#include <gtest/gtest.h>

#include "pipeline/divided.h"
#include "sides/contacts.h"
#include "sides/patched_shape.h"
#include "support/bodies.h"
#include "support/shapes.h"

namespace posture {
namespace {

using test::divided;
using test::person;

TEST(WithBridges, joinsThePiecesOfABodyAndKeepsWhatWasGiven) {
  const TriangleMesh apart = divided(person(0, 0).mesh, 0.5);
  const CleanMesh clean = cleanMesh(apart);
  ASSERT_EQ(clean.summary.components, 2);
  const PatchedShape joined = withBridges(apart, clean);
  EXPECT_EQ(joined.joined_pieces, 1);
  EXPECT_EQ(joined.patch_vertices, 0);
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
  EXPECT_EQ(same.joined_pieces, 0);
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
  ASSERT_EQ(patched.patched_holes, 1);
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
  EXPECT_EQ(patched.patched_holes, 2);
  EXPECT_EQ(patched.parted_contacts, 1);
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

}  // namespace
}  // namespace posture
