// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/encode.h"
#include "support/files.h"
#include "support/shapes.h"
#include <string>
#include <vector>

namespace posture {
namespace {

using test::inputErrorOf;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct BadMesh {
  std::string name, bytes, message;
};

void expectMessages(const std::vector<BadMesh>& cases) {
  const TemporaryFolder folder;
  for (const BadMesh& bad : cases) {
    SCOPED_TRACE(bad.name + ": " + bad.bytes.substr(0, 200));
    const auto path = folder.file(bad.name, bad.bytes);
    const std::string message = inputErrorOf([&] { readMesh(path); });
    EXPECT_THAT(message, StartsWith(path.string() + ": "));
    EXPECT_THAT(message, HasSubstr(bad.message));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
  }
}

std::string garbage() {
  std::string bytes;
  for (int i = 0; i < 3000; ++i) bytes += static_cast<char>((i * 7919 + i / 13 * 31 + 201) % 256);
  return bytes;
}

TEST(BadMesh, notAFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(inputErrorOf([&] { readMesh(folder.path() / "no.ply"); }),
              HasSubstr("no.ply: no such file"));
  EXPECT_THAT(inputErrorOf([&] { readMesh(folder.path()); }), HasSubstr("is a folder"));
  EXPECT_THAT(inputErrorOf([&] { readMesh("/dev/zero"); }), HasSubstr("not a regular file"));
  EXPECT_THAT(inputErrorOf([&] { readMesh(folder.path() / "a\nb.ply"); }), Not(HasSubstr("\n")));
}

TEST(BadMesh, anyFormat) {
  expectMessages({{"a.ply", "", "the file is empty"},
                  {"a.obj", "", "the file is empty"},
                  {"a.txt", "v 0 0 0\n", "unknown format"},
                  {"a.png", "\x89PNG\r\n\x1a\n", "unknown format"},
                  {"a", "\n\n", "unknown format"},
                  {"a.ply.gz", "\x1f\x8b\x08...", "is compressed (gzip): unpack it first"},
                  {"a.obj", "PK\x03\x04...", "is compressed (ZIP)"},
                  {"a.ply", "\xfd\x37zXZ...", "is compressed (xz)"},
                  {"a.ply", "hello\n", "does not begin with 'ply'"},
                  {"a.vtk", "<?xml version=\"1.0\"?>\n", "does not begin with '# vtk DataFile"},
                  {"a.off", "hat 4 0\n", "line 1: 'hat' where OFF is expected"},
                  {"a.off", "4 4 0\n", "line 1: the number of vertices is 4, too many"},
                  {"a.obj", garbage(), "is not an OBJ statement"},
                  {"a.off", garbage(), "where OFF is expected"},
                  {"a.stl", garbage(), "truncated: its head says"},
                  {"a.ply", garbage(), "does not begin with 'ply'"},
                  {"a.ply", "ply\n" + garbage(), "line 2: '"},
                  {"a.bin", garbage(), "unknown format"}});
}

TEST(BadMesh, obj) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expectMessages({{"a.obj", "# nothing\n", "there are no vertices"},
                  {"a.obj", "v 0 0 0\nv 1 x 0\n", "line 2: a vertex: 'x' is not a number"},
                  {"a.obj", "v 0 1,5 0\n", "line 1: a vertex: '1,5' is not a number"},
                  {"a.obj", "v 0 1.5abc 0\n", "'1.5abc' is not a number"},
                  {"a.obj", "v 0 0x10 0\n", "'0x10' is not a number"},
                  {"a.obj", "v 0 +-1 0\n", "'+-1' is not a number"},
                  {"a.obj", three + "v 0 1", "line 4: a vertex of 2 numbers"},
                  {"a.obj", "v 0 1 2 3 4\n", "line 1: a vertex of 5 numbers"},
                  {"a.obj", "v 0 1 2 3 4 5 6 7\n", "more than 7"},
                  {"a.obj", three + "v nan 0 0\n", "line 4: vertex 4 has a coordinate that is not"},
                  {"a.obj", "v 0 inf 0\n", "not finite"},
                  {"a.obj", "v 0 0 -1e999\n", "not finite"},
                  {"a.obj", "v 0 0 1e99999\n", "not finite"},
                  {"a.obj", three + "f 1 2 4\n", "line 4: face index 4 is out of range"},
                  {"a.obj", three + "f 1 2 9999999999\n", "line 4: face index"},
                  {"a.obj", three + "f 1 2 3\nf 1 2", "line 5: a face of 2 corners (truncated?)"},
                  {"a.obj", three + "f 1 2 3\nf", "line 5: a face of 0 corners (truncated?)"},
                  {"a.obj", three + "f 1 2 3\nf 1 2 ", "line 5: a face of 2 corners (truncated?)"},
                  {"a.obj", three + "f 1 2 3\nf 1 2 \\", "a face of 2 corners (truncated?)"},
                  {"a.obj", three + "f 1 2 99999999999999999999\n", "is not a whole number"},
                  {"a.obj", three + "f 1 2 0\n", "line 4: face index 0, OBJ counts from 1"},
                  {"a.obj", three + "f 1 2 -4\n", "line 4: face index -4 is out of range"},
                  {"a.obj", three + "f 1 2 x\n", "line 4: a face index: 'x' is not a whole"},
                  {"a.obj", three + "f 1 2 /3\n", "line 4: a face index is missing"},
                  {"a.obj", three + "f 1/1/1 2/1/x 3\n", "line 4: a face index: 'x'"},
                  {"a.obj", three + "vn 0 0\n", "line 4: a normal is missing"},
                  {"a.obj", three + "vertex 0 0 0\n", "line 4: 'vertex' is not an OBJ statement"},
                  {"a.obj", three + std::string(4, '\0'), "line 4: '\?\?\?\?' is not an OBJ"}});
}

TEST(BadMesh, off) {
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
  expectMessages({{"a.off", "OFF\n", "line 2: the number of vertices is missing"},
                  {"a.off", "OFF\n0\n", "the number of faces is missing"},
                  {"a.off", "OFF\n0 0 0\n", "there are no vertices"},
                  {"a.off", "OFF\n0 x 0\n", "the number of faces: 'x' is not a whole number"},
                  {"a.off", "OFF\n-3 1 0\n", "the number of vertices is negative"},
                  {"a.off", "OFF\n0 -1 0\n", "the number of faces is negative"},
                  {"a.off", "OFF\n2000000000 1 0\n" + three, "too many for the size of the file"},
                  {"a.off", "OFF\n3 99999999999 0\n" + three, "too many for the size of the file"},
                  {"a.off", "OFF\n4 0 0\n" + three, "line 6: truncated: 3 of 4 vertices"},
                  {"a.off", "OFF\n3 2 0\n" + three + "3 0 1 2\n", "truncated: 1 of 2 faces"},
                  {"a.off", "OFF\n3 1 0\n" + three + "3  0  1 ", "line 6: a face index is missing"},
                  {"a.off", "OFF\n3 1 0\n" + three + "3 0 1 3\n", "line 6: face index 3 is out of"},
                  {"a.off", "OFF\n3 1 0\n" + three + "3 0 1 -1\n", "face index -1 is out of"},
                  {"a.off", "OFF\n3 1 0\n" + three + "999 0 1 2\n", "too many for the size"},
                  {"a.off", "OFF\n3 1 0\n" + three + "-3 0 1 2\n", "corners is negative"},
                  {"a.off", "OFF\n3 1 0\n" + three + "3 0 1 2 9 9\n# x\n3 2 1 0\n", "line 8: more"},
                  {"a.off", "OFF\n2 0 0\n" + three, "line 5: more than the 2 vertices and 0 faces"},
                  {"a.off", "OFF\n3 0 0\n0 0 0\n1 0\n0 1 0\n", "line 4: a vertex coordinate is"},
                  {"a.off", "OFF\n1 0 0\n0 nan 0\n", "line 3: vertex 0 has a coordinate"},
                  {"a.off", "COFF\n1 0 0\n0 0 0 1 2\n", "line 3: a vertex colour of 2 numbers"},
                  {"a.off", "NOFF\n1 0 0\n0 0 0 1 2\n", "line 3: a vertex with too few numbers"},
                  {"a.off", "4OFF\n1 0 0\n0 0 0 1\n", "only three coordinates"},
                  {"a.off", "OFF BINARY\n1 0 0\n", "binary OFF cannot be read"}});
}

std::string plyHead(const std::string& format,
                    const std::string& vertices,
                    const std::string& faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

TEST(BadMesh, plyHeader) {
  expectMessages(
      {{"a.ply", "ply\n", "line 2: truncated: the header has no end_header"},
       {"a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "no end_header"},
       {"a.ply", "ply\nelement vertex 0\nend_header\n", "the header names no format"},
       {"a.ply", "ply\nformat text 1.0\nend_header\n", "line 2: unknown format 'text'"},
       {"a.ply", "ply\nformat ascii 1.0\nend_header\n", "there is no element 'vertex'"},
       {"a.ply", "ply\nformat ascii 1.0\nproperty int x\n", "before any element"},
       {"a.ply", "ply\nformat ascii 1.0\nelement vertex -1\n", "is negative: -1"},
       {"a.ply", "ply\nformat ascii 1.0\nelement vertex\n", "'vertex' is missing"},
       {"a.ply", "ply\nformat ascii 1.0\nelement v 1\nelement v 1\n", "a second element"},
       {"a.ply", "ply\nformat ascii 1.0\nelement v 1\nproperty real x\n", "type 'real'"},
       {"a.ply", "ply\nformat ascii 1.0\nelement v 1\nproperty int\n", "without a name"},
       {"a.ply", "ply\nformat ascii 1.0\nvertices 3\n", "'vertices' is not a PLY header"},
       {"a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
        "its vertices have no x, y and z"},
       {"a.ply", plyHead("ascii", "0", "0"), "there are no vertices"},
       {"a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar float x\nproperty float y\n"
        "property float z\nend_header\n1 5 2 3\n",
        "a list where one number is due: 'x'"},
       {"a.ply",
        "ply\nformat binary_little_endian 1.0\nelement e 4000000000\nelement vertex "
        "4000000000\nend_header\n",
        "its vertices have no x, y and z"}});
}

TEST(BadMesh, plyBody) {
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string binary = plyHead("binary_little_endian", "3", "1") + std::string(36, '\0');
  const std::string head = plyHead("ascii", "3", "1");
  expectMessages(
      {{"a.ply", head + "0 0 0\n1 0 0\n0        ", "line 12: a number is missing (truncated)"},
       {"a.ply", head + three + "3 0 1   ", "a number is missing (truncated)"},
       {"a.ply", head + three + "3 0 1 3\n", "line 13: face index 3 is out of range"},
       {"a.ply", head + three + "3 0 -1 2\n", "line 13: face index -1 is out of range"},
       {"a.ply", head + three + "3 0 1.5 2\n", "not a whole number"},
       {"a.ply", head + three + "-3 0 1 2\n", "a list with a length that is none"},
       {"a.ply", head + three + "200 0 1 2\n", "longer than the rest of the file"},
       {"a.ply", head + "0 0 0\n1 x 0\n0 1 0\n", "line 11: a number: 'x' is not a number"},
       {"a.ply", head + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "line 11: vertex 1 has"},
       {"a.ply", head + three + "3 0 1 2\n\n3 2 1 0\n", "line 15: more data than its header says"},
       {"a.ply", plyHead("ascii", "3", "0") + three + "0 0 9\n", "behind 0 times 'face'"},
       {"a.ply",
        binary + std::string(13, '\0') + std::string(13, '\1'),
        "more data than its header"},
       {"a.ply", plyHead("ascii", "2000000000", "1") + three, "2000000000 times 'vertex'"},
       {"a.ply", plyHead("binary_big_endian", "3", "1"), "truncated: its header says 3"},
       {"a.ply", plyHead("binary_big_endian", "90000000000000000", "1"), "truncated"},
       {"a.ply", binary, "truncated: its header says 1 times 'face'"},
       {"a.ply", binary + '\3', "a list is longer than the rest"},
       {"a.ply", binary + '\3' + std::string(11, '\0'), "a list is longer than the rest"},
       {"a.ply", binary + '\3' + std::string(11, '\0') + '\1', "16777216 is out of range"},
       {"a.ply", binary + '\3' + std::string(12, '\xff'), "face index -1 is out of range"},
       {"a.ply",
        plyHead("binary_little_endian", "1", "0") + std::string(12, '\xff'),
        "vertex 0 has a coordinate that is not finite"}});
}

TEST(BadMesh, stl) {
  const std::string loop = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  const std::string binary = test::binaryStl(test::grid(1, 1, 1, 1), "solid");
  std::string many = binary;
  many.replace(80, 4, "\xff\xff\xff\x7f");
  std::string few = binary + "end", none = binary;
  few.replace(80, 1, "\1");
  none.replace(80, 1, 1, '\0');
  std::string infinite = binary;
  infinite.replace(96, 4, test::raw(std::numeric_limits<float>::infinity()));
  expectMessages(
      {{"a.stl", "solid\n", "line 2: truncated: no 'endsolid'"},
       {"a.stl", "solid\nendsolid\n", "there are no vertices"},
       {"a.stl", "solid\nfacets\n", "line 2: 'facets' where 'facet' is expected"},
       {"a.stl", loop, "truncated inside a facet"},
       {"a.stl", loop + "vertex 0 1\n", "a vertex coordinate is missing (truncated)"},
       {"a.stl", loop + "vertex 0 x 0\n", "line 6: a vertex coordinate: 'x'"},
       {"a.stl", loop + "vertex 0 inf 0\n", "line 6: vertex 2 has a coordinate"},
       {"a.stl", loop + "vertex 0 1 0\nendloop\n", "truncated inside a facet"},
       {"a.stl", loop + "endfacet\n", "'endfacet' where 'vertex' is expected"},
       {"a.stl", loop + "endloop\nendfacet\nendsolid\n", "line 6: a facet of 2 vertices"},
       {"a.stl", "short", "truncated: shorter than the head"},
       {"a.stl", binary.substr(0, 150), "its head says 2 facets, there are 1"},
       {"a.stl", many, "its head says 2147483647 facets, there are 2"},
       {"a.stl", few, "its head says 1 facets, there are 2"},
       {"a.stl", none, "its head says 0 facets, there are 2"},
       {"a.stl", infinite, "vertex 0 has a coordinate that is not finite"}});
}

TEST(BadMesh, vtk) {
  const std::string head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n";
  const std::string three = head + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  const std::string grid =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  const std::string binary = "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\n";
  expectMessages(
      {{"a.vtk", "# vtk DataFile Version 3.0\n", "where ASCII or BINARY is expected"},
       {"a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\n", "where DATASET is expected"},
       {"a.vtk",
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",
        "line 4: DATASET 'STRUCTURED_POINTS' is not a surface"},
       {"a.vtk", head, "there are no vertices"},
       {"a.vtk", head + "POINTS 3 float\n0 0 0 1 0            ", "a number is missing (truncated)"},
       {"a.vtk", head + "POINTS 99999999 float\n0 0 0 1 0", "too many for the size"},
       {"a.vtk", head + "POINTS -3 float\n", "is negative"},
       {"a.vtk", head + "POINTS 0 quad\n", "unknown number type 'quad'"},
       {"a.vtk", head + "POINTS 1 float\n0 nan 0\n", "vertex 0 has a coordinate"},
       {"a.vtk", three + "POINTS 1 float\n0 0 0\n", "a second section POINTS"},
       {"a.vtk", three + "POLYGONS 1 4\n3 0 1 3\n", "face index 3 is out of range"},
       {"a.vtk", three + "POLYGONS 1 4\n3 0 1 -1\n", "face index -1 is out of range"},
       {"a.vtk", three + "POLYGONS 1 4\n4 0 1 2\n", "do not add up to 4"},
       {"a.vtk", three + "POLYGONS 1 4\n-4 0 1 2\n", "do not add up to 4"},
       {"a.vtk", three + "POLYGONS 2 4\n3 0 1 2\n", "do not add up to 4"},
       {"a.vtk", three + "POLYGONS 1 8\n3 0 1 2 3 2 1 0\n", "do not add up to 8"},
       {"a.vtk", three + "POLYGONS 2 4\nOFFSETS int\n0 3\nCONNECTIVITY int\n0 1 2 0\n", "end at 3"},
       {"a.vtk", three + "POLYGONS 1 4\n3 0 1   ", "a number is missing (truncated)"},
       {"a.vtk", three + "POLYGONS 1 4000000000\n3 0 1 2\n", "too many for the size"},
       {"a.vtk", three + "POLYGONS 1 4\n3 0 1 1.5\n", "an index that is not a whole number"},
       {"a.vtk", three + "RUBBISH 1\n", "'rubbish' is not a VTK section"},
       {"a.vtk", head + "FIELD f 1\nnames 1 9 string\na\nb\n", "truncated inside"},
       {"a.vtk", binary + "FIELD f 1\nnames 1 1 string\n\xC9name", "an array of strings"},
       {"a.vtk", binary + "FIELD f 1\nnames 1 1 string\n\x3fname", "an array of strings"},
       {"a.vtk", three + "POLYGONS 2 3\nOFFSETS int\n0 4\nCONNECTIVITY int\n0 1 2\n", "an offset"},
       {"a.vtk",
        three + "POLYGONS 2 3\nOFFSETS int\n1 3\nCONNECTIVITY int\n0 1 2\n",
        "begin at 1, not at 0"},
       {"a.vtk",
        three + "POLYGONS 3 3\nOFFSETS int\n0 3 0\nCONNECTIVITY int\n0 1 2\n",
        "an offset"},
       {"a.vtk", three + "POLYGONS 2 3\nOFFSETS int\n0 3\n", "where CONNECTIVITY is expected"},
       {"a.vtk", grid + "CELLS 1 4\n3 0 1 2\n", "1 cells, 0 cell types"},
       {"a.vtk", grid + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n", "cell 0 has type 10"},
       {"a.vtk", binary + "POINTS 3 float\n" + std::string(35, '\0'), "truncated"},
       {"a.vtk",
        binary + "POINTS 3 float\n" + std::string(36, '\0') + "\nPOLYGONS 1 4\n",
        "too many"},
       {"a.vtk", head + "FIELD f 1\na 99999 99999 int\n1\n", "too many for the size"}});
}

}  // namespace
}  // namespace posture
