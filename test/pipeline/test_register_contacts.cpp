// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/clean_mesh.h>
#include <posture/pipeline/register_shapes.h>

#include <gtest/gtest.h>

#include "pipeline/grown_together.h"
#include "support/bodies.h"
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

namespace posture {
namespace {

using test::grownTogether;
using test::person;

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

/// A ribbon wound three times around, each winding joined to the next at every other vertex: no
/// face is without such a place, and to open them leaves next to nothing.
TriangleMesh windings() {
  constexpr int STEPS = 60, COUNT = 3 * STEPS;
  constexpr double HEIGHT = 0.3;
  TriangleMesh mesh;
  mesh.vertices.resize(2 * COUNT + 2, 3);
  for (int i = 0; i <= COUNT; ++i) {
    const double angle = 2 * M_PI * i / STEPS, z = HEIGHT * i / STEPS;
    mesh.vertices.row(2 * i) << std::cos(angle), std::sin(angle), z;
    // The others stay a little below the next winding.
    mesh.vertices.row(2 * i + 1) << std::cos(angle), std::sin(angle),
        z + (i % 2 == 0 ? 1 : 0.8) * HEIGHT;
  }
  const auto top = [&](int i) {
    return i % 2 == 0 && i + STEPS <= COUNT ? 2 * (i + STEPS) : 2 * i + 1;
  };
  mesh.faces.resize(2 * COUNT, 3);
  for (int i = 0; i < COUNT; ++i) {
    mesh.faces.row(2 * i) << 2 * i, 2 * i + 2, top(i + 1);
    mesh.faces.row(2 * i + 1) << 2 * i, top(i + 1), top(i);
  }
  return mesh;
}

TEST(RegisterShapes, keepsItsResultWhereNothingIsLeftOfTheParted) {
  const TriangleMesh mesh = windings();
  bool is_parted = false;
  const RegistrationResult result = registerShapes(mesh, mesh, {}, [&](const StageEvent& event) {
    is_parted = is_parted || (event.attempt == "parted" && event.stage == "reduction");
  });
  EXPECT_TRUE(is_parted);
  EXPECT_EQ(result.source.parted_contacts, 0);
  EXPECT_EQ(result.deformed.rows(), mesh.vertices.rows());
}

TEST(RegisterShapes, endsInEitherAttemptWhereItsObserverSaysSo) {
  struct Enough : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  const TriangleMesh mesh = windings();
  for (const char* attempt : {"", "parted"})
    EXPECT_THROW(registerShapes(mesh,
                                mesh,
                                {},
                                [&](const StageEvent& event) {
                                  if (event.attempt == attempt && event.stage == "reduction")
                                    throw Enough(attempt);
                                }),
                 Enough);
}

TEST(RegisterShapes, findsItsWayThoughTheTargetIsGrownTogether) {
  const ArticulatedBody source = person(0), target = person(3, 1);
  const TriangleMesh fused = grownTogether(target).mesh;
  std::set<std::string> stages, pictures;
  double progress = 0;
  const RegistrationResult result =
      registerShapes(source.mesh, fused, {}, [&](const StageEvent& event) {
        EXPECT_GE(event.progress, progress);
        progress = event.progress;
        if (!event.pictures) {
          const std::string title = stageTitle(event.attempt, event.stage);
          EXPECT_TRUE(stages.insert(title).second) << title << " twice";
          return;
        }
        for (const StagePicture& picture : event.pictures())
          EXPECT_TRUE(pictures.insert(stageTitle(event.attempt, picture.name)).second)
              << picture.name << " twice";
      });
  EXPECT_EQ(result.status, Status::REGISTERED) << result.message;
  EXPECT_EQ(result.target.parted_contacts, 1);
  EXPECT_EQ(result.target.clean_vertices, cleanMesh(fused).mesh.vertices.rows());  // all of it
  EXPECT_LT(meanError(result, source, target), 0.03);
  EXPECT_LE(progress, 1);
  EXPECT_EQ(stages.count("parted refinement"), 1);
  EXPECT_EQ(stages.count("parted annealing"), 1);
  EXPECT_EQ(stages.count("annealing"), 0);  // of what is not taken
  EXPECT_EQ(pictures.count("parted source-canonical-form"), 1);
  EXPECT_EQ(stages.size(), result.timings.size());
}

}  // namespace
}  // namespace posture
