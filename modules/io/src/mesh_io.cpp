// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include "readers.h"
#include "text_reader.h"
#include <new>
#include <string>

namespace posture {
namespace {

bool beginsWith(std::string_view text, std::string_view head) {
  return text.substr(0, head.size()) == head;
}

MeshFile readAnyFormat(const Input& input) {
  const std::string_view bytes = input.bytes();
  const std::string ending = lowercase(input.path().extension().string());
  if (beginsWith(bytes, "ply\n") || beginsWith(bytes, "ply\r")) return readPly(input);
  if (beginsWith(lowercase(bytes.substr(0, 22)), "# vtk datafile version")) return readVtk(input);
  if (isBinaryStl(bytes)) return readStl(input);
  const std::string_view first_word = TextReader(input, 0, '#').word();
  if (isOffKeyword(first_word)) return readOff(input);
  if (ending == ".stl" || lowercase(first_word) == "solid") return readStl(input);
  if (ending == ".obj") return readObj(input);
  if (ending == ".off") return readOff(input);
  if (ending == ".ply") return readPly(input);
  if (ending == ".vtk") input.fail("does not begin with '# vtk DataFile Version'");
  input.fail("unknown format (PLY, OBJ, OFF, STL and legacy VTK can be read)");
}

}  // namespace

MeshFile readMesh(const std::filesystem::path& path) {
  const Input input(path);
  try {
    return readAnyFormat(input);
  } catch (const std::bad_alloc&) {
    input.fail("too large for this machine's memory");
  }
}

}  // namespace posture
