// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>

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

TEST(DataFolder, HoldsWhatItsReadmeSays) {
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

}  // namespace
}  // namespace posture
