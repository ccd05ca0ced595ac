// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/handles.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/synthesis/articulated_body.h>

#include <gtest/gtest.h>

#include "contacts.h"
#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

ArticulatedBody person(int pose, int tessellation = 0) {
  BodyOptions options;
  options.kind = BodyKind::HUMAN;
  options.pose = pose;
  options.vertices = 2500;
  options.tessellation = tessellation;
  return makeBody(options);
}

enum class Contact { TUBE, VERTEX };

/// The body with two places grown together that are near in space and far along the surface.
struct Fused {
  TriangleMesh mesh;
  int a = 0, b = 0;
};

Fused grownTogether(const ArticulatedBody& body, Contact contact = Contact::TUBE) {
  Fused result;
  double best = 0;
  for (int a = 0; a < body.mesh.vertices.rows(); a += 7) {
    const Vector along = pathLengths(body.mesh, {a});
    for (int b = 0; b < body.mesh.vertices.rows(); ++b) {
      const double straight = (body.mesh.vertices.row(a) - body.mesh.vertices.row(b)).norm();
      const double gain = along[b] / (straight + 0.02);
      if (along[b] > 0.5 && gain > best) {
        best = gain;
        result.a = a;
        result.b = b;
      }
    }
  }
  if (contact == Contact::TUBE) {
    result.mesh = test::fused(body.mesh, result.a, result.b);
  } else {
    result.mesh = body.mesh;
    for (int& corner : result.mesh.faces.reshaped())
      if (corner == result.b) corner = result.a;
  }
  return result;
}

double meanError(const RegistrationResult& result,
                 const ArticulatedBody& source,
                 const ArticulatedBody& target) {
  double sum = 0;
  int count = 0;
  for (const VertexPair& pair : groundTruth(source, target)) {
    const int found = result.correspondence.on_target[pair.source].vertex;
    if (found < 0) continue;
    sum += (target.mesh.vertices.row(found) - target.mesh.vertices.row(pair.target)).norm();
    ++count;
  }
  return sum / std::max(count, 1) / std::sqrt(result.target.area);
}

TEST(PartedSurface, LeavesABodyWithoutHandlesAsItIs) {
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

TEST_P(PartedContact, GivesTheDistancesBackThatItShortened) {
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
    return pathLengths(mesh.mesh, {beside(fused.a)})[beside(fused.b)];
  };
  const double true_length = pathLengths(body.mesh, {fused.a})[fused.b];
  EXPECT_LT(lengthBeside(clean), 0.6 * true_length);
  EXPECT_GT(lengthBeside(parted.clean), 0.8 * true_length);
}

TEST(PartedSurface, LeavesSmallHandlesAlone) {
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

TEST(RegisterShapes, FindsItsWayThoughTheTargetIsGrownTogether) {
  const ArticulatedBody source = person(0), target = person(3, 1);
  const RegistrationResult result = registerShapes(source.mesh, grownTogether(target).mesh);
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  EXPECT_LT(meanError(result, source, target), 0.03);
}

}  // namespace
}  // namespace posture
