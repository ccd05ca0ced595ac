// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/rng.h>
#include <posture/core/types.h>

#include <cstring>
#include <string>
#include <vector>

namespace posture::test {

struct EncodedMesh {
  std::string name;  ///< with the ending
  std::string bytes;
};

/// The mesh in every format and encoding that can be read, written without help of the library.
std::vector<EncodedMesh> encodeEveryWay(const TriangleMesh& mesh);

/// The number's bytes, on a little-endian machine.
template <class T>
std::string raw(T value, bool big_endian = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// Cuts the end off, changes some bytes, moves a piece elsewhere or doubles a digit.
std::string damage(std::string bytes, Rng& rng);

/// Head of `title` padded to 80 bytes, then the facets with normal 0.
std::string binaryStl(const TriangleMesh& mesh, const std::string& title);

}  // namespace posture::test
