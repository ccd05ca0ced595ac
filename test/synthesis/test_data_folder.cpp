// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>

#include <gtest/gtest.h>

#include "body_checks.h"
#include <string>

namespace posture {
namespace {

using namespace test;

const std::string folder = DATA_DIR;

void expectShape(const std::string& name, int holes) {
  const TriangleMesh mesh = readMesh(folder + "/" + name).mesh;
  const Topology topology = topologyOf(mesh);
  EXPECT_TRUE(topology.manifold) << name;
  EXPECT_EQ(topology.components, 1) << name;
  EXPECT_EQ(topology.rims, holes) << name;
  EXPECT_EQ(topology.euler, 2 - holes) << name;
}

void expectTruth(const std::string& name, const std::string& source, const std::string& target) {
  const auto n = readMesh(folder + "/" + source).mesh.vertices.rows();
  const auto m = readMesh(folder + "/" + target).mesh.vertices.rows();
  const std::vector<VertexPair> truth = readVertexPairs(folder + "/" + name);
  EXPECT_GT(static_cast<double>(truth.size()), 0.9 * static_cast<double>(n)) << name;
  for (const VertexPair& pair : truth) {
    ASSERT_LT(pair.source, n) << name;
    ASSERT_LT(pair.target, m) << name;
  }
}

TEST(DataFolder, holdsWhatItsReadmeSays) {
  for (const char* pose : {"0", "1", "3"})
    expectShape(std::string("quadruped/quadruped-pose") + pose + ".ply", 6);
  for (const char* pose : {"0", "6"})
    expectShape(std::string("human/human-pose") + pose + ".ply", 0);
  for (const char* end : {".txt", "-mirror.txt"}) {
    for (const char* pose : {"1", "3"})
      expectTruth(std::string("quadruped/quadruped-pose0-pose") + pose + end,
                  "quadruped/quadruped-pose0.ply",
                  std::string("quadruped/quadruped-pose") + pose + ".ply");
    expectTruth(std::string("human/human-pose0-pose6") + end,
                "human/human-pose0.ply",
                "human/human-pose6.ply");
  }
}

TEST(DataFolder, scansAreOfTheirSurfaces) {
  for (const char* pose : {"0", "6"}) {
    const std::string name = folder + "/scans/human-pose" + pose;
    const PointCloud cloud = readShape(name + "-scan.pcd").cloud;
    const TriangleMesh surface = readMesh(name + ".ply").mesh;
    EXPECT_EQ(topologyOf(surface).rims, 0);
    EXPECT_NEAR(static_cast<double>(cloud.points.rows()) / 15000, 1, 0.1);
    EXPECT_TRUE(cloud.points.allFinite());
    EXPECT_EQ(cloud.width, 0);
    const std::vector<VertexPair> places = readVertexPairs(name + "-scan-surface.txt");
    EXPECT_GT(static_cast<double>(places.size()), 0.93 * static_cast<double>(cloud.points.rows()));
    const double edge = meanEdgeOf(surface);
    double sum = 0;
    for (const VertexPair& place : places)
      sum += (cloud.points.row(place.source) - surface.vertices.row(place.target)).norm();
    EXPECT_LT(sum / static_cast<double>(places.size()), 0.6 * edge);
  }
}

TEST(DataFolder, scansHaveTruth) {
  const auto points = [](const char* pose) {
    return readShape(folder + "/scans/human-pose" + pose + "-scan.pcd").cloud.points.rows();
  };
  const auto n = points("0"), m = points("6");
  for (const char* end : {".txt", "-mirror.txt"}) {
    const auto truth = readVertexPairs(folder + "/scans/human-pose0-pose6-scan" + end);
    EXPECT_GT(static_cast<double>(truth.size()), 0.9 * static_cast<double>(n)) << end;
    for (const VertexPair& pair : truth) {
      ASSERT_LT(pair.source, n);
      ASSERT_LT(pair.target, m);
    }
  }
}

}  // namespace
}  // namespace posture
