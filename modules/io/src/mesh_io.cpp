// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include "readers.h"
#include "text.h"
#include "text_reader.h"
#include <new>
#include <string>

namespace posture {
namespace {

bool beginsWith(std::string_view text, std::string_view head) {
  return text.substr(0, head.size()) == head;
}

}  // namespace

MeshFormat signatureOf(const Input& input) {
  const std::string_view text = input.bytes().substr(textBegin(input.bytes()));
  if (beginsWith(text, "ply\n") || beginsWith(text, "ply\r")) return MeshFormat::PLY;
  if (beginsWith(lowercase(text.substr(0, 22)), "# vtk datafile version")) return MeshFormat::VTK;
  if (isBinaryStl(input.bytes())) return MeshFormat::STL;
  const std::string_view first_word = TextReader(input, 0, '#').word();
  if (isOffKeyword(first_word)) return MeshFormat::OFF;
  if (lowercase(first_word) == "solid") return MeshFormat::STL;
  return MeshFormat::UNKNOWN;
}

MeshFormat meshFormatOf(const Input& input) {
  const MeshFormat signature = signatureOf(input);
  if (signature != MeshFormat::UNKNOWN) return signature;
  const std::string ending = lowercase(input.path().extension().string());
  if (ending == ".stl") return MeshFormat::STL;
  if (ending == ".obj") return MeshFormat::OBJ;
  if (ending == ".off") return MeshFormat::OFF;
  if (ending == ".ply") return MeshFormat::PLY;
  if (ending == ".vtk") input.fail("does not begin with '# vtk DataFile Version'");
  return MeshFormat::UNKNOWN;
}

MeshFile readMeshAs(MeshFormat format, const Input& input, Unseen unseen) {
  switch (format) {
    case MeshFormat::PLY:
      return readPly(input, unseen);
    case MeshFormat::OBJ:
      return readObj(input, unseen);
    case MeshFormat::OFF:
      return readOff(input, unseen);
    case MeshFormat::STL:
      return readStl(input);
    case MeshFormat::VTK:
      return readVtk(input, unseen);
    case MeshFormat::UNKNOWN:
      break;
  }
  input.fail("unknown format (PLY, OBJ, OFF, STL and legacy VTK can be read)");
}

MeshFile readMesh(const std::filesystem::path& path) {
  const Input input(path);
  try {
    return readMeshAs(meshFormatOf(input), input, Unseen::REFUSED);
  } catch (const std::bad_alloc&) {
    input.fail("too large for this machine's memory");
  }
}

}  // namespace posture
