// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/nearest_in_triangle.h>
#include <posture/mesh/normals.h>
#include <posture/segmentation/rigid_segments.h>

#include <gtest/gtest.h>

#include "support/bodies.h"
#include "support/cpu_seconds.h"
#include "support/motions.h"
#include "support/shapes.h"
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>

namespace posture {
namespace {

using test::motion;
using test::moved;

constexpr double DEGREE = M_PI / 180;

double angle(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear() * b.linear().transpose()).angle();
}

/// A strip along x, folded by `turn` at x = 1 (of 3), without stretching.
Points folded(const TriangleMesh& strip, double turn) {
  Points places = strip.vertices;
  for (int v = 0; v < places.rows(); ++v) {
    const double beyond = places(v, 0) - 1;
    if (beyond <= 0) continue;
    places(v, 0) = 1 + std::cos(turn) * beyond;
    places(v, 2) = std::sin(turn) * beyond;
  }
  return places;
}

/// Hubert and Arabie 1985.
double adjustedRandIndex(const std::vector<int>& a, const std::vector<int>& b) {
  std::map<std::pair<int, int>, double> both;
  std::map<int, double> of_a, of_b;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ++both[{a[i], b[i]}];
    ++of_a[a[i]];
    ++of_b[b[i]];
  }
  const auto pairs = [](const auto& counts) {
    double sum = 0;
    for (const auto& entry : counts) sum += entry.second * (entry.second - 1) / 2;
    return sum;
  };
  const auto n = static_cast<double>(a.size());
  const double expected = pairs(of_a) * pairs(of_b) / (n * (n - 1) / 2);
  return (pairs(both) - expected) / (0.5 * (pairs(of_a) + pairs(of_b)) - expected);
}

bool facesAreConnected(const TriangleMesh& mesh, const RigidSegments& segments) {
  const Faces across = facesAcross(mesh.faces);
  std::vector<char> seen(mesh.faces.rows(), 0), part_seen(segments.count, 0);
  for (int start = 0; start < mesh.faces.rows(); ++start) {
    if (seen[start]) continue;
    const int part = segments.face_label[start];
    if (part_seen[part]) return false;
    part_seen[part] = 1;
    std::queue<int> open;
    open.push(start);
    seen[start] = 1;
    while (!open.empty()) {
      const int f = open.front();
      open.pop();
      for (int k = 0; k < 3; ++k) {
        const int g = across(f, k);
        if (g < 0 || seen[g] || segments.face_label[g] != part) continue;
        seen[g] = 1;
        open.push(g);
      }
    }
  }
  return true;
}

/// A body at rest and in other poses, with the motion of each bone.
struct Poses {
  explicit Poses(BodyKind kind, const std::vector<int>& which) : rest(body(kind, 0)) {
    for (int pose : which) {
      bodies.push_back(body(kind, pose));
      places.push_back(bodies.back().mesh.vertices);
    }
  }

  /// Making one takes half a second: once is enough.
  static const ArticulatedBody& body(BodyKind kind, int pose) {
    static std::map<std::pair<BodyKind, int>, ArticulatedBody> made;
    const auto [entry, is_new] = made.try_emplace({kind, pose});
    if (is_new) entry->second = test::body(pose, 1500, 0, kind);
    return entry->second;
  }

  Eigen::Isometry3d boneMotion(int pose, int bone) const {
    return bodies[pose].bone_motion[bone] * rest.bone_motion[bone].inverse();
  }

  /// Bones that touch and turn against each other by less than `least` (root mean square over the
  /// poses) are one.
  std::vector<int> bonesThatMove(double least) const {
    std::vector<int> joined(rest.bone_names.size());
    std::iota(joined.begin(), joined.end(), 0);
    for (const Edge& e : meshEdges(rest.mesh.faces)) {
      const int a = rest.bone[e.first], b = rest.bone[e.second];
      double sum = 0;
      for (std::size_t k = 0; k < bodies.size(); ++k) {
        const double turn =
            angle(boneMotion(static_cast<int>(k), a), boneMotion(static_cast<int>(k), b));
        sum += turn * turn / static_cast<double>(bodies.size());
      }
      if (std::sqrt(sum) >= least || joined[a] == joined[b]) continue;
      const int gone = joined[b], kept = joined[a];
      for (int& bone : joined)
        if (bone == gone) bone = kept;
    }
    return joined;
  }

  ArticulatedBody rest;
  std::vector<ArticulatedBody> bodies;
  std::vector<Points> places;
};

/// Over the vertices that one bone alone moves.
double agreement(const Poses& poses, const RigidSegments& segments) {
  const std::vector<int> joined = poses.bonesThatMove(segments.least_turn);
  std::vector<int> bones, parts;
  for (std::size_t v = 0; v < segments.label.size(); ++v) {
    if (poses.rest.bone_weight[static_cast<int>(v)] < 0.99) continue;
    bones.push_back(joined[poses.rest.bone[v]]);
    parts.push_back(segments.label[v]);
  }
  return adjustedRandIndex(bones, parts);
}

TEST(RigidSegments, aFoldHasTwoSides) {
  const TriangleMesh strip = test::grid(60, 12, 3, 0.6);
  for (double turn : {20 * DEGREE, 90 * DEGREE}) {
    const RigidSegments segments = segmentRigidParts(strip, {folded(strip, turn)});
    ASSERT_EQ(segments.count, 2);
    for (int v = 0; v < strip.vertices.rows(); ++v) {
      const double x = strip.vertices(v, 0);
      if (std::abs(x - 1) < 0.06) continue;
      EXPECT_EQ(segments.label[v], x > 1 ? 0 : 1) << x;  // the larger part comes first
    }
    EXPECT_LT(angle(segments.motion[0][1], Eigen::Isometry3d::Identity()), 1e-6);
    EXPECT_NEAR(angle(segments.motion[0][0], segments.motion[0][1]), turn, 1e-6);
    EXPECT_NEAR(segments.scale[0], 1, 1e-9);
  }
}

TEST(RigidSegments, whatDoesNotBendIsOnePart) {
  const TriangleMesh mesh = test::sphere(4);
  const Eigen::Isometry3d by = motion(1);
  const Points copy = moved(2.5 * mesh.vertices, by);
  const RigidSegments segments = segmentRigidParts(mesh, {copy, mesh.vertices});
  EXPECT_EQ(segments.count, 1);
  EXPECT_NEAR(segments.scale[0], 2.5, 1e-9);
  EXPECT_NEAR(segments.scale[1], 1, 1e-12);
  EXPECT_LT((segments.motion[0][0].matrix() - by.matrix()).norm(), 1e-6);
  EXPECT_LT((segments.motion[1][0].matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-6);
}

TEST(RigidSegments, noiseIsNoMotion) {
  const TriangleMesh mesh = test::sphere(4);
  const int n = static_cast<int>(mesh.vertices.rows());
  const Points noisy = mesh.vertices + 0.1 * meanEdgeLength(mesh) * test::randomPoints(n, 3);
  EXPECT_EQ(segmentRigidParts(mesh, {noisy}).count, 1);
}

TEST(RigidSegments, doNotDependOnThePlaceOfThePose) {
  const TriangleMesh strip = test::grid(60, 12, 3, 0.6);
  const Points pose = folded(strip, 0.7);
  const Eigen::Isometry3d by = motion(2);
  const RigidSegments once = segmentRigidParts(strip, {pose}),
                      again = segmentRigidParts(strip, {moved(3 * pose, by)});
  EXPECT_EQ(once.face_label, again.face_label);
  EXPECT_NEAR(again.scale[0], 3, 1e-9);
  for (int part = 0; part < once.count; ++part)
    EXPECT_NEAR(angle(again.motion[0][part], by * once.motion[0][part]), 0, 1e-6);
}

TEST(RigidSegments, aJointThatBendsInOnePoseOnlyCounts) {
  const TriangleMesh strip = test::grid(60, 12, 3, 0.6);
  EXPECT_EQ(segmentRigidParts(strip, {strip.vertices, folded(strip, 1), strip.vertices}).count, 2);
}

TEST(RigidSegments, areThoseOfANoisyBodyToo) {
  Poses poses(BodyKind::HUMAN, {2});
  const int n = static_cast<int>(poses.places[0].rows());
  poses.places[0] += 0.05 * meanEdgeLength(poses.rest.mesh) * test::randomPoints(n, 3);
  EXPECT_GE(agreement(poses, segmentRigidParts(poses.rest.mesh, poses.places)), 0.85);
}

/// As registrations err: every vertex on the surface, but not at its own place on it. Errors are
/// alike over limbs.
Points slid(const TriangleMesh& posed, double by) {
  const Points normals = vertexNormals(posed);
  Points places = posed.vertices;
  for (int v = 0; v < places.rows(); ++v) {
    const Eigen::Vector3d at = posed.vertices.row(v), normal = normals.row(v);
    const Eigen::Vector3d flow(std::sin(9 * at[2] + 1), std::sin(8 * at[0]), std::sin(7 * at[1]));
    const Eigen::Vector3d wanted = at + by * (flow - flow.dot(normal) * normal);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& f : posed.faces.rowwise()) {
      const Eigen::Vector3d a = posed.vertices.row(f[0]), b = posed.vertices.row(f[1]),
                            c = posed.vertices.row(f[2]);
      if ((a - wanted).norm() > 4 * by + (b - a).norm()) continue;
      const Eigen::Vector3d w = nearestInTriangle(wanted, a, b, c);
      const Eigen::Vector3d place = w[0] * a + w[1] * b + w[2] * c;
      if ((place - wanted).squaredNorm() >= least) continue;
      least = (place - wanted).squaredNorm();
      places.row(v) = place;
    }
  }
  return places;
}

TEST(RigidSegments, mayBeSeenAtTheWrongPlaceOfTheSurface) {
  Poses poses(BodyKind::QUADRUPED, {5});
  const double edge = meanEdgeLength(poses.rest.mesh);
  for (double by : {0.3, 0.5, 0.8}) {
    poses.places[0] = slid(poses.bodies[0].mesh, by * edge);
    EXPECT_GE(agreement(poses, segmentRigidParts(poses.rest.mesh, poses.places)), 0.85) << by;
  }
}

TEST(RigidSegments, areTheBonesOfABody) {
  for (BodyKind kind : {BodyKind::QUADRUPED, BodyKind::HUMAN})
    for (int pose : {2, 4}) {
      const Poses poses(kind, {pose});
      const RigidSegments segments = segmentRigidParts(poses.rest.mesh, poses.places);
      EXPECT_GE(agreement(poses, segments), 0.85) << pose;
      EXPECT_TRUE(facesAreConnected(poses.rest.mesh, segments));
    }
}

TEST(RigidSegments, holdAcrossSeveralPoses) {
  const Poses poses(BodyKind::HUMAN, {2, 4});
  const RigidSegments segments = segmentRigidParts(poses.rest.mesh, poses.places);
  EXPECT_GE(agreement(poses, segments), 0.85);
  EXPECT_EQ(segments.motion.size(), 2u);
}

TEST(RigidSegments, moveAsTheirBonesDo) {
  const Poses poses(BodyKind::QUADRUPED, {2, 4});
  const RigidSegments segments = segmentRigidParts(poses.rest.mesh, poses.places);
  // The bone that moves most of a part, where it moves most of it rigidly.
  int compared = 0;
  for (int part = 0; part < segments.count; ++part) {
    std::map<int, int> rigid;
    int size = 0;
    for (std::size_t v = 0; v < segments.label.size(); ++v) {
      if (segments.label[v] != part) continue;
      ++size;
      if (poses.rest.bone_weight[static_cast<int>(v)] >= 0.99) ++rigid[poses.rest.bone[v]];
    }
    for (const auto& [bone, count] : rigid) {
      if (count < size / 2) continue;
      ++compared;
      for (int k = 0; k < 2; ++k)
        EXPECT_LT(angle(segments.motion[k][part], poses.boneMotion(k, bone)), 2 * DEGREE)
            << poses.rest.bone_names[bone];
    }
  }
  EXPECT_GE(compared, 5);  // the trunk and the legs
}

TEST(RigidSegments, everyFaceAndVertexHasAPart) {
  TriangleMesh mesh = test::grid(20, 5, 3, 0.6);
  const auto n = mesh.vertices.rows(), m = mesh.faces.rows();
  mesh.vertices.conservativeResize(n + 4, 3);  // a loose face, and a vertex in none
  mesh.vertices.bottomRows(4) << 5, 0, 0, 6, 0, 0, 5, 1, 0, 9, 9, 9;
  mesh.faces.conservativeResize(m + 2, 3);
  mesh.faces.bottomRows(2) << n, n + 1, n + 2, 0, 1, 1;  // and one without area
  const RigidSegments segments = segmentRigidParts(mesh, {folded(mesh, 0.5)});
  for (int part : segments.face_label) {
    EXPECT_GE(part, 0);
    EXPECT_LT(part, segments.count);
  }
  for (int v = 0; v < n + 3; ++v) EXPECT_GE(segments.label[v], 0);
  EXPECT_EQ(segments.label[n + 3], -1);
}

TEST(RigidSegments, areFoundBesideManyLoosePieces) {
  // A folded strip, and more flaps beside it than clusters are compared.
  constexpr int FLAPS = 200;
  TriangleMesh mesh = test::grid(60, 12, 3, 0.6);
  const int n = static_cast<int>(mesh.vertices.rows()), m = static_cast<int>(mesh.faces.rows());
  mesh.vertices.conservativeResize(n + 3 * FLAPS, 3);
  mesh.faces.conservativeResize(m + FLAPS, 3);
  for (int k = 0; k < FLAPS; ++k) {
    const int v = n + 3 * k;
    const double x = 3.0 * k / FLAPS;
    mesh.vertices.middleRows(v, 3) << x, 1, 0, x + 0.01, 1, 0, x, 1.01, 0;
    mesh.faces.row(m + k) << v, v + 1, v + 2;
  }
  const RigidSegments segments = segmentRigidParts(mesh, {folded(mesh, 1)});
  EXPECT_EQ(segments.count, FLAPS + 2);
  for (int v = 0; v < n; ++v) {
    const double x = mesh.vertices(v, 0);
    if (std::abs(x - 1) > 0.06) {
      EXPECT_EQ(segments.label[v], x > 1 ? 0 : 1) << x;
    }
  }
}

TEST(RigidSegments, takeNoLongerWhereTheMotionIsExact) {
  const TriangleMesh mesh = test::sphere(5);
  const int n = static_cast<int>(mesh.vertices.rows());
  const auto seconds = [&](const Points& pose) {
    return test::cpuSeconds([&] { EXPECT_EQ(segmentRigidParts(mesh, {pose}).count, 1); });
  };
  const double noisy = seconds(mesh.vertices + 1e-3 * test::randomPoints(n, 3));
  EXPECT_LT(seconds(mesh.vertices), 3 * noisy);
  EXPECT_LT(seconds(moved(mesh.vertices, motion(1))), 3 * noisy);
}

TEST(RigidSegments, refuseWhatDoesNotFit) {
  const TriangleMesh mesh = test::grid(4, 4, 1, 1);
  EXPECT_THROW(segmentRigidParts(mesh, {}), std::invalid_argument);
  EXPECT_THROW(segmentRigidParts(mesh, {mesh.vertices.topRows(3)}), std::invalid_argument);
  EXPECT_THROW(segmentRigidParts({mesh.vertices, Faces(0, 3)}, {mesh.vertices}),
               std::invalid_argument);
  TriangleMesh point = mesh;
  point.vertices.setZero();
  EXPECT_THROW(segmentRigidParts(point, {mesh.vertices}), std::invalid_argument);
  TriangleMesh unknown = mesh;
  unknown.vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(segmentRigidParts(mesh, {unknown.vertices}), std::invalid_argument);
}

}  // namespace
}  // namespace posture
