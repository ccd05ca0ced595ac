// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two meshes of one body in two poses, from files; where each vertex of the first is on the second,
// to a file.
//   01_register_meshes SOURCE TARGET CORRESPONDENCE.csv
#include <posture/core/error.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/pipeline/register_shapes.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s SOURCE TARGET CORRESPONDENCE.csv\n", argv[0]);
    return 2;
  }
  try {
    const posture::TriangleMesh source = posture::readMesh(argv[1]).mesh;
    const posture::TriangleMesh target = posture::readMesh(argv[2]).mesh;

    const posture::RegistrationResult result = posture::registerShapes(source, target);
    std::printf("%s\n", result.message.c_str());

    const posture::SurfacePoint& place = result.correspondence.on_target[0];
    if (place.vertex >= 0)
      std::printf("vertex 0 lies nearest to vertex %d, in face %d, with confidence %.2f\n",
                  place.vertex,
                  place.face,
                  result.correspondence.confidence[0]);
    posture::writeCorrespondence(argv[3], result.correspondence);
    return result.status == posture::Status::REGISTERED ? 0 : 1;
  } catch (const posture::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
