// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/edge_paths.h>
#include <posture/mesh/handles.h>
#include <posture/pipeline/register_shapes.h>

#include <gtest/gtest.h>

#include "sides/contacts.h"
#include "support/bodies.h"
#include "support/cpu_seconds.h"
#include "support/shapes.h"
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

namespace posture {
namespace {

using test::person;

enum class Contact { TUBE, VERTEX };

/// The body with two places grown together that are near in space and far along the surface.
struct Fused {
  TriangleMesh mesh;
  int a = 0, b = 0;
};

Fused grownTogether(const ArticulatedBody& body, Contact contact = Contact::TUBE) {
  Fused result;
  double best = 0;
  const EdgePaths paths(body.mesh);
  for (int a = 0; a < body.mesh.vertices.rows(); a += 7) {
    const Vector along = paths.lengths({a});
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
    return EdgePaths(mesh.mesh).lengths({beside(fused.a)})[beside(fused.b)];
  };
  const double true_length = EdgePaths(body.mesh).lengths({fused.a})[fused.b];
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

TEST(PartedSurface, TakesLittleLongerForManySmallHandles) {
  const auto secondsFor = [](int holes) {
    const TriangleMesh mesh = plateWithHoles(45, holes);
    const CleanMesh clean = cleanMesh(mesh);
    EXPECT_EQ(Handles(clean.mesh).count(), holes);
    return test::cpuSeconds([&] { EXPECT_EQ(partedSurface(mesh, clean).contacts, 0); });
  };
  const double few = secondsFor(8);
  EXPECT_LT(secondsFor(200), 5 * few);
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

TEST(RegisterShapes, KeepsItsResultWhereNothingIsLeftOfTheParted) {
  const TriangleMesh mesh = windings();
  bool is_parted = false;
  const RegistrationResult result = registerShapes(mesh, mesh, {}, [&](const StageEvent& event) {
    is_parted = is_parted || (event.attempt == "parted" && event.stage == "reduction");
  });
  EXPECT_TRUE(is_parted);
  EXPECT_EQ(result.source.parted_contacts, 0);
  EXPECT_EQ(result.deformed.rows(), mesh.vertices.rows());
}

TEST(RegisterShapes, EndsInEitherAttemptWhereItsObserverSaysSo) {
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

TEST(RegisterShapes, FindsItsWayThoughTheTargetIsGrownTogether) {
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
