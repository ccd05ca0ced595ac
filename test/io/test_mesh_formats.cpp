// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include <gtest/gtest.h>

#include "io/encode.h"
#include "support/files.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

namespace posture {
namespace {

using test::raw;
using test::TemporaryFolder;

MeshFile parse(const std::string& ending, const std::string& bytes) {
  const TemporaryFolder folder;
  return readMesh(folder.file("mesh" + ending, bytes));
}

Faces faces(std::initializer_list<Eigen::RowVector3i> rows) {
  Faces result(static_cast<Eigen::Index>(rows.size()), 3);
  Eigen::Index i = 0;
  for (const auto& row : rows) result.row(i++) = row;
  return result;
}

Points points(std::initializer_list<Eigen::RowVector3d> rows) {
  Points result(static_cast<Eigen::Index>(rows.size()), 3);
  Eigen::Index i = 0;
  for (const auto& row : rows) result.row(i++) = row;
  return result;
}

Colors colors(std::initializer_list<Eigen::RowVector3i> rows) {
  return faces(rows).cast<std::uint8_t>();
}

const Points corner_triangle = points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
const Points up_normals = points({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
const Colors red_green_blue = colors({{255, 0, 0}, {0, 255, 0}, {0, 0, 255}});
const std::string four_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, polygonsAreCutAndSmallOnesSkipped) {
  const MeshFile file = parse(".obj", four_vertices + "v -1 1 0\nf 1 2 3 4\nf 1 2\nf 1 4 5\n");
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(parse(".obj", four_vertices + "f\nf 1 2 3\nf 1 2\n").mesh.faces, faces({{0, 1, 2}}));
}

/// A polygon, laid into the plane x + y + z = 0, and what it is cut into, as areas with a sign.
struct CutPolygon {
  explicit CutPolygon(const std::vector<Eigen::Vector2d>& corners) {
    std::ostringstream text;
    text.precision(17);
    std::string face = "f";
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
      const Eigen::Vector3d p = a.x() * Eigen::Vector3d(1, -1, 0).normalized() +
                                a.y() * Eigen::Vector3d(1, 1, -2).normalized();
      text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
      face += " " + std::to_string(i + 1);
    }
    const Faces triangles = parse(".obj", text.str() + face + "\n").mesh.faces;
    std::vector<int> of_corner(corners.size(), 0);
    for (const auto& t : triangles.rowwise()) {
      const Eigen::Vector2d ab = corners[t[1]] - corners[t[0]], ac = corners[t[2]] - corners[t[0]];
      const double part = (ab.x() * ac.y() - ab.y() * ac.x()) / 2;
      least = std::min(least, part);
      sum += part;
      for (int v : t) most = std::max(most, ++of_corner[v]);
    }
    fewest = *std::min_element(of_corner.begin(), of_corner.end());
    count = static_cast<int>(triangles.rows());
  }

  double area = 0, sum = 0, least = 1e9;
  int count = 0, fewest = 0, most = 0;  // triangles, and those at one corner
};

TEST(Obj, concavePolygonsAreCutWithin) {
  // A U, an arrow head from each of its corners, and a square with a square hole, bridged.
  const std::vector<std::vector<Eigen::Vector2d>> shapes{
      {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},
      {{0, 0}, {2, -1}, {0, 3}, {-2, -1}},
      {{2, -1}, {0, 3}, {-2, -1}, {0, 0}},
      {{2, 5},
       {2, 4},
       {0, 6},
       {1, 0},
       {4, 0},
       {6, 0},
       {7, 1},
       {6, 2},
       {7, 4},
       {5, 2},
       {6, 6},
       {2, 7}},
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}};
  for (std::size_t k = 0; k < shapes.size(); ++k)
    for (std::size_t from = 0; from < shapes[k].size(); ++from) {
      std::vector<Eigen::Vector2d> corners = shapes[k];
      std::rotate(
          corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(from), corners.end());
      const CutPolygon cut(corners);
      EXPECT_EQ(cut.count, static_cast<int>(corners.size()) - 2);
      EXPECT_NEAR(cut.sum, cut.area, 1e-9) << k << " from " << from;
      EXPECT_GT(cut.least, -1e-9) << k << " from " << from;
    }
}

TEST(Obj, anEarDoesNotPassBeforeACornerThatLiesOnItsSide) {
  const MeshFile file = parse(".obj",
                              "v 2 7 0\nv 6 6 0\nv 5 2 0\nv 7 4 0\nv 6 2 0\nv 7 1 0\nv 6 0 0\n"
                              "v 4 0 0\nv 1 0 0\nv 0 6 0\nv 2 4 0\nv 2 5 0\n"
                              "f 1 2 3 4 5 6 7 8 9 10 11 12\n");
  double covered = 0;
  for (const auto& t : file.mesh.faces.rowwise()) {
    const Eigen::RowVector3d ab = file.mesh.vertices.row(t[1]) - file.mesh.vertices.row(t[0]),
                             ac = file.mesh.vertices.row(t[2]) - file.mesh.vertices.row(t[0]);
    covered += std::abs(ab.x() * ac.y() - ab.y() * ac.x()) / 2;
  }
  EXPECT_NEAR(covered, 33, 1e-9) << "its area; overlapping triangles have more";
}

TEST(Obj, noCornerOfALargePolygonGetsManyTriangles) {
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < 1000; ++i)
    corners.emplace_back(std::cos(2 * M_PI * i / 1000), std::sin(2 * M_PI * i / 1000));
  const CutPolygon cut(corners);
  EXPECT_NEAR(cut.sum, cut.area, 1e-9);
  EXPECT_LE(cut.most, 22) << "two for each time that the corners are halved";
}

TEST(Obj, polygonsWithoutAreaAreCutAsWell) {
  for (const std::vector<Eigen::Vector2d>& corners :
       std::vector<std::vector<Eigen::Vector2d>>{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}},
                                                 {{1, 1}, {1, 1}, {1, 1}, {1, 1}},
                                                 {{0, 0}, {2, 2}, {2, 0}, {0, 2}}}) {
    const CutPolygon cut(corners);
    EXPECT_GE(cut.fewest, 1) << "each corner is used";
    EXPECT_NEAR(cut.sum, cut.area, 1e-12);
  }
}

TEST(Obj, negativeIndicesCountBackFromWhereTheyStand) {
  const MeshFile file = parse(".obj", four_vertices + "f -4 -3 -2\nv 9 9 9\nf -1 -2 1\n");
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {4, 3, 0}}));
}

TEST(Obj, facesMayStandBeforeTheirVertices) {
  EXPECT_EQ(parse(".obj", "f 1 2 3\n" + four_vertices).mesh.faces, faces({{0, 1, 2}}));
}

TEST(Obj, texturesNormalsGroupsAndComments) {
  const MeshFile file = parse(".obj",
                              "# head\nmtllib a b.mtl\no thing\n\nv 0 0 0 # first\nv 1 0 0\n"
                              "  v\t0 1 0\nvt 0 0\nvn 0 0 1\nvn 0 0 -1\ng part\ns off\n"
                              "usemtl red\nf 1/1/1 2/1/1 3//1 # end\nf 3//2 2//2 1//2\nl 1 2\n");
  EXPECT_EQ(file.mesh.vertices, corner_triangle);
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(file.normals, up_normals);
}

TEST(Obj, normalsInOrderWhereNoFaceNamesThem) {
  const std::string vertices = "v 0 0 0\nvn 0 0 1\nv 1 0 0\nvn 0 0 1\nv 0 1 0\n";
  EXPECT_EQ(parse(".obj", vertices + "vn 0 0 1\n").normals, up_normals);
  EXPECT_EQ(parse(".obj", vertices).normals.rows(), 0);
}

TEST(Obj, noNormalsWhereAFaceNamesOneThatIsNotThere) {
  // 2^64 / 3 rows of three numbers each would begin again at the first one.
  for (const char* number : {"2", "6148914691236517206", "6148914691236517207"}) {
    const std::string corner = std::string("//") + number;
    const MeshFile file =
        parse(".obj",
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1" + corner + " 2" + corner + " 3" + corner);
    EXPECT_EQ(file.normals.rows(), 0) << number;
  }
}

TEST(Obj, colorsBehindThePosition) {
  const char* unit = "v 0 0 0 1 0 0\nv 1 0 0 0 1.0 0\nv 0 1 0 0 0 1\n";
  const char* byte = "v 0 0 0 255 0 0\nv 1 0 0 0 255 0\nv 0 1 0 0 0 255\n";
  const char* alpha = "v 0 0 0 1 0 0 1\nv 1 0 0 0 1 0 1\nv 0 1 0 0 0 1 1\n";
  for (const char* text : {unit, byte, alpha}) {
    EXPECT_EQ(parse(".obj", text).mesh.vertices, corner_triangle);
    EXPECT_EQ(parse(".obj", text).colors, red_green_blue);
  }
  EXPECT_EQ(parse(".obj", "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\n").colors.rows(), 0);
}

TEST(Obj, weightsAndContinuedLines) {
  const MeshFile file =
      parse(".obj", "v 0 0 0 1.0\nv 1 0 \\\n0 1\nv +0 1 -0 1\nf 1 2\\\r\n 3\nf 1 \\\n2 3\n");
  EXPECT_EQ(file.mesh.vertices, corner_triangle);
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {0, 1, 2}}));
  EXPECT_EQ(file.colors.rows(), 0);
}

TEST(Obj, aBackslashWithinALineContinuesNothing) {
  EXPECT_EQ(parse(".obj", "mtllib C:\\my files\\ scan.mtl\n" + four_vertices).mesh.vertices,
            parse(".obj", four_vertices).mesh.vertices);
}

TEST(TextMeshes, linesOfAClassicMac) {
  const std::vector<std::pair<const char*, std::string>> files{
      {".obj", "# c\rv 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"},
      {".off", "OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r"},
      {".ply",
       "ply\rformat ascii 1.0\relement vertex 3\rproperty float x\rproperty float y\r"
       "property float z\relement face 1\rproperty list uchar int vertex_indices\rend_header\r"
       "0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r"}};
  for (const auto& [ending, text] : files) {
    EXPECT_EQ(parse(ending, text).mesh.vertices, corner_triangle) << ending;
    EXPECT_EQ(parse(ending, text).mesh.faces, faces({{0, 1, 2}})) << ending;
  }
}

TEST(Off, countsOnTheFirstLineOrTheNext) {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string head : {"OFF\n3 1 0\n",
                                 "OFF 3 1 0\n",
                                 "OFF\n3 1\n",
                                 "# c\nOFF # c\n\n# c\n3 1 0 # c\n\n",
                                 "OFF\n3\n1 0\n"}) {
    EXPECT_EQ(parse(".off", head + body).mesh.vertices, corner_triangle) << head;
    EXPECT_EQ(parse(".off", head + body).mesh.faces, faces({{0, 1, 2}})) << head;
  }
}

TEST(Off, theKeywordMayBeInSmallLettersOrMissing) {
  const std::string body = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string head : {"off\n", "# by hand\n", ""})
    EXPECT_EQ(parse(".off", head + body).mesh.vertices, corner_triangle) << head;
  const MeshFile file =
      parse(".mesh", "noff\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n");
  EXPECT_EQ(file.normals, up_normals);
}

TEST(Off, polygonsAndTrailingFaceColors) {
  const MeshFile file = parse(".off",
                              "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0 # last\n"
                              "4 0 1 2 3 255 0 0\n3 0 1 2 0.5 0.5 0.5 1\n2 0 1\n3 1 2 3 7\n");
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {1, 2, 3}}));
}

TEST(Off, vertexColorsAndNormals) {
  const std::string face = "3 0 1 2\n";
  const MeshFile byte = parse(".off",
                              "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n"
                              "0 1 0 0 0 255 255\n" +
                                  face);
  const MeshFile unit =
      parse(".off", "COFF\n3 1 0\n0 0 0 1.0 0 0\n1 0 0 0 1.0 0\n0 1 0 0 0 1.0\n" + face);
  const MeshFile normal =
      parse(".off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n" + face);
  EXPECT_EQ(byte.colors, red_green_blue);
  EXPECT_EQ(unit.colors, red_green_blue);
  EXPECT_EQ(normal.normals, up_normals);
  for (const MeshFile& file : {byte, unit, normal}) EXPECT_EQ(file.mesh.vertices, corner_triangle);
}

TEST(Off, geomviewHasNormalsFirstAndMeshlabColorsFirst) {
  const MeshFile geomview = parse(".off",
                                  "STCNOFF\n3 0 0\n0 0 0 0 0 1 255 0 0 255 0.5 0.5\n"
                                  "1 0 0 0 0 1 0 255 0 255 0.5 0.5\n"
                                  "0 1 0 0 0 1 0 0 255 255 0.5 0.5\n");
  const MeshFile meshlab = parse(".off",
                                 "NCOFF\n3 0 0\n0 0 0 255 0 0 255 0 0 1\n"
                                 "1 0 0 0 255 0 255 0 0 1\n0 1 0 0 0 255 255 0 0 1\n");
  for (const MeshFile& file : {geomview, meshlab}) {
    EXPECT_EQ(file.mesh.vertices, corner_triangle);
    EXPECT_EQ(file.colors, red_green_blue);
    EXPECT_EQ(file.normals, up_normals);
  }
}

TEST(Ply, anyOrderExtraPropertiesAndExtraElements) {
  const MeshFile file =
      parse(".ply",
            "ply\nformat ascii 1.0\ncomment made by hand\nobj_info x\nelement camera 1\n"
            "property float view_px\nproperty list int float lens\nelement vertex 3\n"
            "property uchar blue\nproperty float z\nproperty uchar red\nproperty double y\n"
            "property list uchar short neighbours\nproperty float32 x\nproperty float quality\n"
            "property uchar green\nproperty float ny\nproperty float nx\nproperty float nz\n"
            "element empty 0\nelement face 2\nproperty uchar flag\n"
            "property list uint8 int32 vertex_index\nproperty list uchar float texcoord\n"
            "element edge 1\nproperty int vertex1\nend_header\n9 2 0.5 0.5\n"
            "0 0 255 0 2 7 8 0 0.1 0 0 0 1\n0 0 0 0 0 1 0.2 255 0 0 1\n"
            "255 0 0 1 1 5 0 0.3 0 0 0 1\n1 3 0 1 2 2 0.1 0.2\n0 4 0 1 2 0 0\n4\n");
  EXPECT_EQ(file.mesh.vertices, corner_triangle);
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {0, 1, 2}, {0, 2, 0}}));
  EXPECT_EQ(file.colors, red_green_blue);
  EXPECT_EQ(file.normals, up_normals);
}

std::string binaryPlyOfEveryType(bool big) {
  std::string out = std::string("ply\nformat ") +
                    (big ? "binary_big_endian" : "binary_little_endian") +
                    " 1.0\nelement vertex 3\nproperty char a\nproperty short x\nproperty ushort b\n"
                    "property list ushort uint c\nproperty int y\nproperty double z\n"
                    "property ushort red\nproperty ushort green\nproperty ushort blue\n"
                    "element face 1\nproperty list uint ushort vertex_indices\nend_header\n";
  for (int v = 0; v < 3; ++v) {
    out += raw(std::int8_t{-1}) + raw(static_cast<std::int16_t>(v == 1), big) +
           raw(std::uint16_t{9}, big) + raw(std::uint16_t{2}, big) + raw(5u, big) + raw(6u, big) +
           raw(int{v == 2}, big) + raw(0.0, big);
    for (int c = 0; c < 3; ++c) out += raw(static_cast<std::uint16_t>(c == v ? 65535 : 0), big);
  }
  out += raw(3u, big);
  for (int c = 0; c < 3; ++c) out += raw(static_cast<std::uint16_t>(c), big);
  return out;
}

TEST(Ply, everyNumberTypeInBothByteOrders) {
  for (const bool big : {false, true}) {
    const MeshFile file = parse(".ply", binaryPlyOfEveryType(big));
    EXPECT_EQ(file.mesh.vertices, corner_triangle);
    EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}}));
    EXPECT_EQ(file.colors, red_green_blue);
  }
}

TEST(Ply, floatColorsWindowsHeaderAndStrips) {
  const std::string head =
      "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
      "property float z\r\nproperty float red\r\nproperty float green\r\nproperty float blue\r\n"
      "element tristrips 1\r\nproperty list int int vertex_indices\r\nend_header\r\n";
  const MeshFile file =
      parse(".ply", head + "0 0 0 1 0 0\r\n1 0 0 0 1 0\r\n0 1 0 0 0 1\r\n8 0 1 2 0 -1 2 1 0\r\n");
  EXPECT_EQ(file.colors, red_green_blue);
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {2, 1, 0}, {2, 1, 0}}));
}

TEST(Ply, coloursThatAreNoBytesBecomeTheNearestOnes) {
  const MeshFile file = parse(".ply",
                              "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                              "property float y\nproperty float z\nproperty float red\n"
                              "property float green\nproperty float blue\nend_header\n"
                              "0 0 0 inf nan -inf\n1 0 0 254.5 300 -7\n");
  ASSERT_EQ(file.colors.rows(), 2);
  EXPECT_EQ(file.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(255, 0, 0)));
  EXPECT_EQ(file.colors.row(1), (Eigen::Matrix<std::uint8_t, 1, 3>(255, 255, 0)));
}

TEST(Ply, normalsThatAreNoNumbersAreLeftOut) {
  const MeshFile file =
      parse(".ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
            "property float y\nproperty float z\nproperty float nx\n"
            "property float ny\nproperty float nz\nend_header\n1 2 3 nan 0 -nan\n");
  EXPECT_EQ(file.mesh.vertices, points({{1, 2, 3}}));
  EXPECT_EQ(file.normals.rows(), 0);
}

TEST(MeshFormats, zerosAndTheEndOfFileMarkOfDosMayStandBehindText) {
  const TriangleMesh mesh = test::grid(1, 1, 1, 1);
  int texts = 0;
  for (const test::EncodedMesh& file : test::encodeEveryWay(mesh)) {
    const std::string ending = file.name.substr(file.name.rfind('.'));
    if (ending != ".off" && !(ending == ".ply" && file.name.rfind("ascii", 0) == 0)) continue;
    ++texts;
    SCOPED_TRACE(file.name);
    for (const std::string& end :
         {std::string(5, '\0'), std::string("\x1a"), std::string("\n\x1a\0", 3)})
      EXPECT_EQ(parse(ending, file.bytes + end).mesh.faces, mesh.faces);
  }
  EXPECT_GE(texts, 2);
}

TEST(MeshFormats, asManyOfThemAsThereAre) {
  const std::string two_faces = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  std::string end;
  for (int i = 0; i < 1000000; ++i) end += i % 2 == 0 ? '\0' : '\n';
  EXPECT_EQ(parse(".off", two_faces + end).mesh.faces, faces({{0, 1, 2}, {0, 2, 3}}));
  EXPECT_THROW(parse(".off", two_faces + end + "x"), InputError);
}

TEST(Ply, whatIsNoFaceMayStandBehindTheLast) {
  const TriangleMesh mesh = test::grid(1, 1, 1, 1);
  for (const test::EncodedMesh& file : test::encodeEveryWay(mesh)) {
    if (file.name.find(".ply") == std::string::npos) continue;
    SCOPED_TRACE(file.name);
    EXPECT_EQ(parse(".ply", file.bytes + "\r\n \n" + std::string(20, '\n')).mesh.faces, mesh.faces);
    if (file.name.find("ascii") != std::string::npos) continue;
    EXPECT_EQ(parse(".ply", file.bytes + std::string(12, 'x')).mesh.faces, mesh.faces);
    EXPECT_EQ(parse(".ply", file.bytes + std::string(999, '\0')).mesh.faces, mesh.faces);
  }
}

TEST(Stl, capitalsSeveralSolidsAndPolygons) {
  const std::string facet =
      "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\n"
      "ENDFACET\n";
  const MeshFile file =
      parse(".stl", "SOLID a b c\n" + facet + "ENDSOLID a b c\nsolid\n" + facet + "endsolid");
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(file.mesh.vertices.topRows(3), corner_triangle);
}

TEST(Stl, blankLinesMayComeBeforeIt) {
  EXPECT_EQ(parse(".stl",
                  "\n \r\nsolid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                  "vertex 0 1 0\nendloop\nendfacet\nendsolid\n")
                .mesh.faces.rows(),
            1);
}

TEST(Stl, binaryMayHaveBytesBehindIt) {
  const std::string bytes = test::binaryStl(test::grid(1, 1, 1, 1), "solid x");
  for (const std::string& more :
       {std::string("more"), std::string(49, 'x'), std::string(999, '\0')})
    EXPECT_EQ(parse(".stl", bytes + more).mesh.faces.rows(), 2);
}

const std::string vtk_head = "# vtk DataFile Version 3.0\n\nASCII\n";
const std::string vtk_points = "POINTS 4 float\n0 0 0  1 0 0  1 1 0\n0 1 0\n";

TEST(Vtk, sectionsThatDoNotMatterAreSkipped) {
  const MeshFile file = parse(
      ".vtk",
      vtk_head +
          "DATASET POLYDATA\nFIELD FieldData 2\nTIME 1 1 double\n3.5\nMETADATA\n"
          "INFORMATION 1\nNAME a LOCATION b\nDATA 1\n\nname 2 2 int\n1 2 3 4\n" +
          vtk_points + "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nPOLYGONS 2 9\n4 0 1 2 3\n3 0 1 2\n" +
          "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\nPOINT_DATA 4\nanything at all\n");
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 1, 3}, {3, 1, 2}}));
}

TEST(Vtk, fieldsOfStringsAreSkipped) {
  const std::string field = "DATASET POLYDATA\nFIELD f 2\nnames 2 2 string\n";
  const std::string polygon = "POLYGONS 1 4\n3 0 1 2\n";
  const MeshFile text = parse(
      ".vtk", vtk_head + field + "POINTS\n\na%20hat\n7\nTIME 1 1 int\n3\n" + vtk_points + polygon);
  EXPECT_EQ(text.mesh.faces, faces({{0, 1, 2}}));
  // Lengths in one byte, two, four and eight.
  std::string binary = "# vtk DataFile Version 3.0\nt\nBINARY\n" + field + "\xC3" + "hat" +
                       std::string("\x80\x46", 2) + std::string(70, '\n') +
                       std::string("\x40\0\0\2ab", 6) + std::string("\0\0\0\0\0\0\0\1c", 9) +
                       "\nTIME 1 1 int\n" + raw(3, true) + "\nPOINTS 3 float\n";
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) binary += raw(x, true);
  binary += "\nPOLYGONS 1 4\n";
  for (const int i : {3, 0, 1, 2}) binary += raw(i, true);
  EXPECT_EQ(parse(".vtk", binary).mesh.vertices, corner_triangle);
}

TEST(Vtk, unstructuredGridsOfPolygons) {
  const MeshFile file = parse(".vtk",
                              vtk_head + "DATASET UNSTRUCTURED_GRID\n" + vtk_points +
                                  "CELLS 5 21\n3 0 1 2\n4 0 1 2 3\n4 0 1 3 2\n2 0 1\n3 0 1 2\n"
                                  "CELL_TYPES 5\n5 9 8 3 7\n");
  EXPECT_EQ(file.mesh.faces,
            faces({{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
}

TEST(Vtk, binaryFloatsAndFields) {
  std::string text =
      "# vtk DataFile Version 2.0\nt\nBINARY\nDATASET POLYDATA\nFIELD f 1\na 1 2 short\n" +
      raw(std::int16_t{1}, true) + raw(std::int16_t{2}, true) + "\nPOINTS 3 float\n";
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) text += raw(x, true);
  text += "\nTRIANGLE_STRIPS 1 4\n";
  for (const int i : {3, 0, 1, 2}) text += raw(i, true);
  const MeshFile file = parse(".vtk", text);
  EXPECT_EQ(file.mesh.vertices, corner_triangle);
  EXPECT_EQ(file.mesh.faces, faces({{0, 1, 2}}));
}

}  // namespace
}  // namespace posture
