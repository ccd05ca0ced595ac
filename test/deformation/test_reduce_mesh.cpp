// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/deformation/reduce_mesh.h>
#include <posture/geodesic/fast_marching.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/half_edge_mesh.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include "support/topology.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace posture {
namespace {

using test::eulerNumber;

int vertexCount(const TriangleMesh& mesh) { return static_cast<int>(mesh.vertices.rows()); }

int boundaryLoops(const TriangleMesh& mesh) {
  std::map<int, int> next;  // along the boundary
  const HalfEdgeMesh half_edges(mesh.faces, vertexCount(mesh));
  for (int h = 0; h < half_edges.halfEdgeCount(); ++h)
    if (half_edges.twin(h) < 0) next[half_edges.origin(h)] = half_edges.target(h);
  int loops = 0;
  while (!next.empty()) {
    ++loops;
    for (int v = next.begin()->first; next.count(v) > 0;) {
      const int from = v;
      v = next[from];
      next.erase(from);
    }
  }
  return loops;
}

/// Faces, each turned to begin with its least corner.
std::set<std::array<int, 3>> faceSet(const Faces& faces) {
  std::set<std::array<int, 3>> all;
  for (int f = 0; f < faces.rows(); ++f) {
    std::array<int, 3> corners{faces(f, 0), faces(f, 1), faces(f, 2)};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

/// Faces of all shapes over a rectangle: a grid with its inner vertices moved about and its edges
/// flipped at random wherever that leaves no face upside down.
TriangleMesh randomTriangulation(int columns, int rows, std::uint64_t seed) {
  TriangleMesh mesh = test::grid(columns, rows, columns, rows);
  Rng rng(seed);
  for (int v = 0; v < vertexCount(mesh); ++v) {
    const double x = mesh.vertices(v, 0), y = mesh.vertices(v, 1);
    if (x > 0 && x < columns) mesh.vertices(v, 0) += 0.6 * (rng.uniform() - 0.5);
    if (y > 0 && y < rows) mesh.vertices(v, 1) += 0.6 * (rng.uniform() - 0.5);
  }
  HalfEdgeMesh half_edges(mesh.faces, vertexCount(mesh));
  const auto signedArea = [&](int h) {
    const Eigen::Vector3d a = mesh.vertices.row(half_edges.origin(h)),
                          b = mesh.vertices.row(half_edges.target(h)),
                          c = mesh.vertices.row(half_edges.origin(HalfEdgeMesh::previous(h)));
    return (b - a).cross(c - a).z();
  };
  for (int i = 0; i < 20 * vertexCount(mesh); ++i) {
    const int h = rng.below(half_edges.halfEdgeCount());
    if (!half_edges.canFlip(h)) continue;
    half_edges.flip(h);
    if (signedArea(h) < 0.01 || signedArea(half_edges.twin(h)) < 0.01) half_edges.flip(h);
  }
  mesh.faces = half_edges.faces();
  return mesh;
}

/// The greatest sum of the angles opposite an edge that could be flipped.
double worstSum(const TriangleMesh& mesh) {
  const HalfEdgeMesh half_edges(mesh.faces, vertexCount(mesh));
  const auto opposite = [&](int h) {
    const Eigen::Vector3d c = mesh.vertices.row(half_edges.origin(HalfEdgeMesh::previous(h)));
    const Eigen::Vector3d u = mesh.vertices.row(half_edges.origin(h)).transpose() - c,
                          v = mesh.vertices.row(half_edges.target(h)).transpose() - c;
    return std::acos(u.normalized().dot(v.normalized()));
  };
  double worst = 0;
  for (int h = 0; h < half_edges.halfEdgeCount(); ++h)
    if (half_edges.canFlip(h)) worst = std::max(worst, opposite(h) + opposite(half_edges.twin(h)));
  return worst;
}

/// What holds of every mesh reduced.
void expectReduced(const TriangleMesh& mesh, const ReducedMesh& reduced) {
  const int n = vertexCount(mesh), r = vertexCount(reduced.mesh);
  ASSERT_EQ(reduced.vertex.size(), static_cast<std::size_t>(r));
  ASSERT_EQ(reduced.nearest.size(), static_cast<std::size_t>(n));
  std::set<int> distinct;
  for (int i = 0; i < r; ++i) {
    ASSERT_GE(reduced.vertex[i], 0);
    ASSERT_LT(reduced.vertex[i], n);
    EXPECT_TRUE(distinct.insert(reduced.vertex[i]).second);
    EXPECT_EQ(reduced.mesh.vertices.row(i), mesh.vertices.row(reduced.vertex[i]));
    EXPECT_EQ(reduced.nearest[reduced.vertex[i]], i);
  }
  for (int v : reduced.nearest) {
    EXPECT_GE(v, 0);
    EXPECT_LT(v, r);
  }
  ASSERT_GT(reduced.mesh.faces.rows(), 0);
  for (int f = 0; f < reduced.mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      ASSERT_GE(reduced.mesh.faces(f, k), 0);
      ASSERT_LT(reduced.mesh.faces(f, k), r);
      EXPECT_NE(reduced.mesh.faces(f, k), reduced.mesh.faces(f, (k + 1) % 3));
    }
  const CleaningSummary found = cleanMesh(reduced.mesh).summary;
  EXPECT_EQ(found.unreferenced_vertices, 0);
  EXPECT_EQ(found.components, 1);
}

TEST(ReduceMesh, keepsAsManyVerticesAsAskedFor) {
  const TriangleMesh sphere = test::sphere(4);
  for (int count : {4, 10, 100, 1000}) {
    const ReducedMesh reduced = reduceMesh(sphere, count);
    expectReduced(sphere, reduced);
    EXPECT_EQ(vertexCount(reduced.mesh), count);
    EXPECT_EQ(eulerNumber(reduced.mesh), 2);
    EXPECT_EQ(HalfEdgeMesh(reduced.mesh.faces, count).check(), "");
  }
}

TEST(ReduceMesh, anyPrefixIsSpreadEvenly) {
  const TriangleMesh sphere = test::sphere(4);
  const ReducedMesh reduced = reduceMesh(sphere, 300);
  for (int prefix : {10, 50, 150, 300}) {
    const Points places = reduced.mesh.vertices.topRows(prefix);
    double covering = 0, separation = std::numeric_limits<double>::infinity();
    for (int v = 0; v < vertexCount(sphere); ++v)
      covering = std::max(covering,
                          (places.rowwise() - sphere.vertices.row(v)).rowwise().norm().minCoeff());
    for (int i = 0; i < prefix; ++i)
      for (int j = 0; j < i; ++j)
        separation = std::min(separation, (places.row(i) - places.row(j)).norm());
    // Each was the vertex farthest from those before it.
    EXPECT_GT(separation, 0.8 * covering) << prefix;
  }
}

TEST(ReduceMesh, nearestIsNearAlongTheSurface) {
  // Rolled up until its ends all but meet: there the nearest in space is on the wrong end.
  const TriangleMesh flat = test::grid(80, 8, 8, 0.8),
                     rolled = test::bentStrip(80, 8, 8, 0.8, 6.25);
  const ReducedMesh reduced = reduceMesh(rolled, 40);
  expectReduced(rolled, reduced);
  const double edge = meanEdgeLength(rolled);
  for (int v = 0; v < vertexCount(rolled); ++v) {
    const auto distance = [&](int i) {
      return (flat.vertices.row(v) - flat.vertices.row(reduced.vertex[i])).norm();
    };
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < vertexCount(reduced.mesh); ++i) least = std::min(least, distance(i));
    EXPECT_LT(distance(reduced.nearest[v]), least + 0.2 * edge) << v;
  }
}

TEST(ReduceMesh, keepsTheFacesOfAMeshThatIsSmallEnough) {
  for (const TriangleMesh& mesh : {test::sphere(2), randomTriangulation(9, 6, 6)})
    for (int count : {vertexCount(mesh), 3 * vertexCount(mesh)}) {
      const ReducedMesh reduced = reduceMesh(mesh, count);
      expectReduced(mesh, reduced);
      ASSERT_EQ(vertexCount(reduced.mesh), vertexCount(mesh));
      Faces as_given = reduced.mesh.faces;
      for (int i = 0; i < as_given.size(); ++i)
        as_given.data()[i] = reduced.vertex[as_given.data()[i]];
      EXPECT_EQ(faceSet(as_given), faceSet(mesh.faces));
    }
}

TEST(ReduceMesh, keepsHolesHoles) {
  // A sheet with two holes, and a sphere with one.
  TriangleMesh sheet = test::grid(30, 15, 2, 1), sphere = test::sphere(4);
  const auto punch = [](TriangleMesh& mesh, const Eigen::RowVector3d& centre, double radius) {
    Faces kept(mesh.faces.rows(), 3);
    int count = 0;
    for (int f = 0; f < mesh.faces.rows(); ++f)
      if ((mesh.vertices.row(mesh.faces(f, 0)) - centre).norm() > radius)
        kept.row(count++) = mesh.faces.row(f);
    mesh.faces = kept.topRows(count);
    mesh = cleanMesh(mesh).mesh;
  };
  punch(sheet, {0.5, 0.5, 0}, 0.2);
  punch(sheet, {1.5, 0.5, 0}, 0.25);
  punch(sphere, {0, 0, 1}, 0.4);
  const std::array<const TriangleMesh*, 2> meshes{&sheet, &sphere};
  const std::array<int, 2> loops{3, 1};
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(boundaryLoops(*meshes[i]), loops[i]);
    const ReducedMesh reduced = reduceMesh(*meshes[i], 150);
    expectReduced(*meshes[i], reduced);
    EXPECT_EQ(vertexCount(reduced.mesh), 150);
    EXPECT_EQ(boundaryLoops(reduced.mesh), loops[i]);
    EXPECT_EQ(eulerNumber(reduced.mesh), eulerNumber(*meshes[i]));
  }
}

TEST(ReduceMesh, staysNearTheSurface) {
  const TriangleMesh sphere = test::sphere(4);
  const ReducedMesh reduced = reduceMesh(sphere, 300);
  // Equilateral faces of 300 vertices have edges of 0.22: their middles lie 0.01 below the sphere.
  for (int f = 0; f < reduced.mesh.faces.rows(); ++f) {
    Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) centre += reduced.mesh.vertices.row(reduced.mesh.faces(f, k)) / 3;
    EXPECT_GT(centre.norm(), 1 - 0.05);
  }
  EXPECT_GT(faceAreas(reduced.mesh).sum(), 0.96 * faceAreas(sphere).sum());
}

TEST(ReduceMesh, endsWithDelaunayFaces) {
  const TriangleMesh mesh = randomTriangulation(20, 15, 7);
  const ReducedMesh reduced = reduceMesh(mesh, 120);
  EXPECT_LT(worstSum(reduced.mesh), 3.14159265358979 + 1e-5);
}

TEST(ReduceMesh, takesStrangeMeshes) {
  const TriangleMesh sphere = test::sphere(2);
  const int n = vertexCount(sphere), m = static_cast<int>(sphere.faces.rows());
  std::vector<TriangleMesh> strange(6, sphere);

  TriangleMesh& finned = strange[0];  // a third face on each edge of the first one
  finned.vertices.conservativeResize(n + 1, 3);
  finned.vertices.row(n) << 2, 2, 2;
  finned.faces.conservativeResize(m + 3, 3);
  for (int k = 0; k < 3; ++k)
    finned.faces.row(m + k) << sphere.faces(0, k), sphere.faces(0, (k + 1) % 3), n;

  TriangleMesh& tied = strange[1];  // two spheres on one vertex
  tied = test::joined(sphere, test::shifted(sphere, 2 * sphere.vertices.row(0)));
  int antipode = 0;
  (tied.vertices.bottomRows(n).rowwise() - tied.vertices.row(0))
      .rowwise()
      .norm()
      .minCoeff(&antipode);
  for (int i = 0; i < tied.faces.size(); ++i)
    if (tied.faces.data()[i] == n + antipode) tied.faces.data()[i] = 0;

  TriangleMesh& turned = strange[2];  // every third face inside out
  for (int f = 0; f < m; f += 3) std::swap(turned.faces(f, 0), turned.faces(f, 1));

  TriangleMesh& loose = strange[3];  // vertices in no face, one at the place of another
  loose.vertices.conservativeResize(n + 2, 3);
  loose.vertices.bottomRows(2) << 3, 3, 3, sphere.vertices.row(5);

  TriangleMesh& doubled = strange[4];  // a face twice, and a vertex split into two at one place
  doubled.vertices.conservativeResize(n + 1, 3);
  doubled.vertices.row(n) = sphere.vertices.row(7);
  doubled.faces.conservativeResize(m + 2, 3);
  doubled.faces.row(m) = sphere.faces.row(0);
  for (int f = 0, split = 0; split < 2; ++f)
    for (int k = 0; k < 3; ++k)
      if (doubled.faces(f, k) == 7) {
        doubled.faces(f, k) = n;
        doubled.faces.row(m + 1) << 7, n, sphere.faces(f, (k + 1) % 3);  // without area
        ++split;
      }

  TriangleMesh& led = strange[5];  // first a vertex in no face, at the place of another
  led.vertices.resize(n + 1, 3);
  led.vertices << sphere.vertices.row(5), sphere.vertices;
  led.faces.array() += 1;

  for (std::size_t i = 0; i < strange.size(); ++i)
    for (int count : {20, 100, 1000}) {
      SCOPED_TRACE(testing::Message() << i << " reduced to " << count);
      const ReducedMesh reduced = reduceMesh(strange[i], count);
      expectReduced(strange[i], reduced);
      if (&strange[i] != &loose) continue;
      EXPECT_EQ(reduced.nearest[n + 1], reduced.nearest[5]);
    }
}

TEST(ReduceMesh, takesAMoebiusBand) {
  // A strip whose last column is sewn to its first one upside down.
  const int columns = 40, rows = 6;
  TriangleMesh band = test::grid(columns, rows, 1, 1);
  for (int i = 0; i < band.faces.size(); ++i) {
    int& v = band.faces.data()[i];
    const int row = v / (columns + 1), column = v % (columns + 1);
    if (column == columns) v = (rows - row) * (columns + 1);
  }
  for (int v = 0; v < vertexCount(band); ++v) {
    const double turn = 2 * 3.14159265358979 * (v % (columns + 1)) / columns;
    const double across = 0.8 * (band.vertices(v, 1) - 0.5);
    band.vertices.row(v) << (2 + across * std::cos(turn / 2)) * std::cos(turn),
        (2 + across * std::cos(turn / 2)) * std::sin(turn), across * std::sin(turn / 2);
  }
  band = cleanMesh(band).mesh;
  ASSERT_EQ(eulerNumber(band), 0);
  for (int count : {60, 1000}) expectReduced(band, reduceMesh(band, count));
}

TEST(ReduceMesh, takesTheSmallestMeshes) {
  for (const TriangleMesh& mesh : {test::grid(1, 1, 1, 1), test::sphere(0)})
    for (int count : {4, 5, 50}) expectReduced(mesh, reduceMesh(mesh, count));
}

TEST(DelaunayFlips, leaveNoAnglesAbovePiInAPlane) {
  for (std::uint64_t seed : {1, 2, 3}) {
    TriangleMesh mesh = randomTriangulation(15, 12, seed);
    ASSERT_GT(worstSum(mesh), 5);
    const Faces before = mesh.faces;
    mesh.faces = delaunayFlips(mesh);
    EXPECT_LT(worstSum(mesh), 3.14159265358979 + 1e-5);
    EXPECT_EQ(mesh.faces.rows(), before.rows());
    EXPECT_NEAR(faceAreas(mesh).sum(), 15 * 12, 1e-9);
    EXPECT_EQ(HalfEdgeMesh(mesh.faces, vertexCount(mesh)).check(), "");
    for (int f = 0; f < mesh.faces.rows(); ++f) {
      const Eigen::Vector3d a = mesh.vertices.row(mesh.faces(f, 0)),
                            b = mesh.vertices.row(mesh.faces(f, 1)),
                            c = mesh.vertices.row(mesh.faces(f, 2));
      EXPECT_GT((b - a).cross(c - a).z(), 0) << "upside down";
    }
  }
}

TEST(DelaunayFlips, noVertexLiesInACircumcircle) {
  // What Delaunay asks for, of all vertices and not of neighbours alone.
  TriangleMesh mesh = randomTriangulation(10, 8, 4);
  mesh.faces = delaunayFlips(mesh);
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector2d a = mesh.vertices.row(mesh.faces(f, 0)).head(2),
                             b = mesh.vertices.row(mesh.faces(f, 1)).head(2),
                             c = mesh.vertices.row(mesh.faces(f, 2)).head(2);
    Eigen::Matrix2d sides;
    sides << b - a, c - a;
    const Eigen::Vector2d half(0.5 * (b - a).squaredNorm(), 0.5 * (c - a).squaredNorm());
    const Eigen::RowVector2d to_centre = sides.fullPivLu().solve(half).transpose();
    const double radius = to_centre.norm();
    for (int v = 0; v < vertexCount(mesh); ++v)
      EXPECT_GT((mesh.vertices.row(v).head(2) - a - to_centre).norm(), radius * (1 - 1e-4));
  }
}

TEST(DelaunayFlips, leaveADelaunayMeshAsItIs) {
  for (const TriangleMesh& mesh : {test::sphere(3), test::bentStrip(20, 6, 3, 1, 2)})
    EXPECT_EQ(delaunayFlips(mesh), mesh.faces);
}

TEST(DelaunayFlips, doNotFoldTheSurface) {
  // A flap folded over onto the face it hinges on, and a little past it: without the hinge one face
  // would look down.
  TriangleMesh flap;
  flap.vertices.resize(4, 3);
  flap.vertices << -1, 0, 0, 1, 0, 0, 0, 0.2, 0, 0, 0.3, 0.05;
  flap.faces.resize(2, 3);
  flap.faces << 0, 1, 2, 1, 0, 3;
  EXPECT_EQ(faceSet(delaunayFlips(flap)), faceSet(flap.faces));
  flap.vertices.row(3) << 0, -0.3, 0;  // unfolded, it is flipped
  EXPECT_NE(faceSet(delaunayFlips(flap)), faceSet(flap.faces));
}

TEST(DelaunayFlips, takeNonManifoldAndDegenerateMeshes) {
  TriangleMesh mesh = randomTriangulation(6, 5, 5);
  const int n = vertexCount(mesh), m = static_cast<int>(mesh.faces.rows());
  mesh.vertices.conservativeResize(n + 2, 3);
  mesh.vertices.row(n) << 1, 1, 2;
  mesh.vertices.row(n + 1) = mesh.vertices.row(10);
  mesh.faces.conservativeResize(m + 3, 3);
  mesh.faces.row(m) << mesh.faces(3, 0), mesh.faces(3, 1), n;
  mesh.faces.row(m + 1) << mesh.faces(3, 1), mesh.faces(3, 0), n;
  mesh.faces.row(m + 2) << 10, mesh.faces(8, 1), n + 1;
  const Faces flipped = delaunayFlips(mesh);
  EXPECT_EQ(flipped.rows(), m + 3);
  EXPECT_GE(flipped.minCoeff(), 0);
  EXPECT_LT(flipped.maxCoeff(), n + 2);
  EXPECT_EQ(delaunayFlips({mesh.vertices, Faces(0, 3)}).rows(), 0);
}

}  // namespace
}  // namespace posture
