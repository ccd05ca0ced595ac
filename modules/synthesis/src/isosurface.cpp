// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "isosurface.h"

#include <posture/core/matrix_of.h>
#include <posture/core/parallel.h>
#include <posture/core/rng.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace posture::synthesis {
namespace {

/// Samples of the field at the points origin + rotation * spacing * (i, j, k).
struct Lattice {
  Eigen::Matrix3d rotation;
  Vec3 origin;
  double spacing;
  std::array<int, 3> size;
  std::vector<float> value;

  int index(int i, int j, int k) const { return (k * size[1] + j) * size[0] + i; }
  Vec3 place(int index_) const {
    const int i = index_ % size[0], j = index_ / size[0] % size[1], k = index_ / size[0] / size[1];
    return origin + rotation * (spacing * Vec3(i, j, k));
  }
};

Lattice makeLattice(const FleshField& field, double spacing, int tessellation) {
  Rng rng(0x51ull + static_cast<std::uint64_t>(static_cast<std::int64_t>(tessellation)));
  Lattice lattice;
  const double w = rng.normal(), z = rng.normal(), y = rng.normal(), x = rng.normal();
  lattice.rotation = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  lattice.spacing = spacing;
  Vec3 low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = corner >> axis & 1 ? field.upperCorner()[axis] : field.lowerCorner()[axis];
    const Vec3 local = lattice.rotation.transpose() * p;
    low = low.cwiseMin(local);
    high = high.cwiseMax(local);
  }
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] -= spacing * (1 + rng.uniform());
    lattice.size[axis] = static_cast<int>((high[axis] - low[axis]) / spacing) + 3;
  }
  lattice.origin = lattice.rotation * low;
  return lattice;
}

constexpr int COARSEST_BLOCK = 16, FINEST_BLOCK = 2;

/// A cube of `size` values along each axis, as far as the lattice has it. Where it is far from the
/// skin its middle stands for all of it.
void sampleBlock(const FleshField& field,
                 Lattice& lattice,
                 const std::array<int, 3>& first,
                 int size) {
  std::array<int, 3> end;
  for (int axis = 0; axis < 3; ++axis) {
    end[axis] = std::min(first[axis] + size, lattice.size[axis]);
    if (first[axis] >= end[axis]) return;
  }
  const double far = 3 * 0.5 * std::sqrt(3.0) * size * lattice.spacing;
  const Vec3 middle = Vec3(first[0], first[1], first[2]) + Vec3::Constant(0.5 * (size - 1));
  const double here = field.value(lattice.origin + lattice.rotation * (lattice.spacing * middle));
  const bool is_far = std::abs(here) > far;
  if (!is_far && size > FINEST_BLOCK) {
    for (int k : {0, size / 2})
      for (int j : {0, size / 2})
        for (int i : {0, size / 2})
          sampleBlock(field, lattice, {first[0] + i, first[1] + j, first[2] + k}, size / 2);
    return;
  }
  for (int k = first[2]; k < end[2]; ++k)
    for (int j = first[1]; j < end[1]; ++j)
      for (int i = first[0]; i < end[0]; ++i) {
        const int n = lattice.index(i, j, k);
        lattice.value[n] = static_cast<float>(is_far ? here : field.value(lattice.place(n)));
      }
}

void sample(const FleshField& field, Lattice& lattice) {
  const auto [nx, ny, nz] = lattice.size;
  lattice.value.resize(static_cast<std::size_t>(nx) * ny * nz);
  const auto blocksOf = [](int count) { return (count + COARSEST_BLOCK - 1) / COARSEST_BLOCK; };
  const int across = blocksOf(ny);
  parallelFor(across * blocksOf(nz), [&](int row) {
    const int j = row % across * COARSEST_BLOCK, k = row / across * COARSEST_BLOCK;
    for (int i = 0; i < lattice.size[0]; i += COARSEST_BLOCK)
      sampleBlock(field, lattice, {i, j, k}, COARSEST_BLOCK);
  });
}

class Marcher {
 public:
  explicit Marcher(const Lattice& lattice) : lattice_(lattice) {}

  /// Whether the skin passes through the cell whose first corner is `n`.
  bool isCrossed(int n) const {
    const int j = lattice_.size[0], k = j * lattice_.size[1];
    const bool is_inside = inside(n);
    for (int corner : {n + 1, n + j, n + j + 1, n + k, n + k + 1, n + k + j, n + k + j + 1})
      if (inside(corner) != is_inside) return true;
    return false;
  }

  /// The triangles where the skin crosses a tetrahedron of lattice points.
  void march(const std::array<int, 4>& tet) {
    int in[4], out[4], num_in = 0, num_out = 0;
    for (int n : tet) (inside(n) ? in[num_in++] : out[num_out++]) = n;
    if (num_in == 1) {
      triangle({in[0], in[0], in[0]}, {out[0], out[1], out[2]}, in, num_in, out, num_out);
    } else if (num_in == 3) {
      triangle({in[0], in[1], in[2]}, {out[0], out[0], out[0]}, in, num_in, out, num_out);
    } else if (num_in == 2) {
      triangle({in[0], in[0], in[1]}, {out[0], out[1], out[1]}, in, num_in, out, num_out);
      triangle({in[0], in[1], in[1]}, {out[0], out[1], out[0]}, in, num_in, out, num_out);
    }
  }

  TriangleMesh mesh() const { return {matrixOf<Points>(points_), matrixOf<Faces>(faces_)}; }

 private:
  bool inside(int n) const { return lattice_.value[n] < 0; }

  int crossing(int in, int out) {
    const std::uint64_t key = static_cast<std::uint64_t>(in) << 32 | static_cast<unsigned>(out);
    const auto [entry, is_new] = vertex_of_edge_.try_emplace(key, static_cast<int>(points_.size()));
    if (is_new) {
      const double a = lattice_.value[in], b = lattice_.value[out];
      const double t = std::clamp(a / (a - b), 0.05, 0.95);
      points_.emplace_back((1 - t) * lattice_.place(in) + t * lattice_.place(out));
    }
    return entry->second;
  }

  /// Turned outwards by the middles of the edges, which are never degenerate.
  void triangle(const std::array<int, 3>& from,
                const std::array<int, 3>& to,
                const int* in,
                int num_in,
                const int* out,
                int num_out) {
    Vec3 middle[3], outwards = Vec3::Zero();
    std::array<int, 3> face;
    for (int i = 0; i < 3; ++i) {
      middle[i] = lattice_.place(from[i]) + lattice_.place(to[i]);
      face[i] = crossing(from[i], to[i]);
    }
    for (int i = 0; i < num_in; ++i) outwards -= lattice_.place(in[i]) / num_in;
    for (int i = 0; i < num_out; ++i) outwards += lattice_.place(out[i]) / num_out;
    if ((middle[1] - middle[0]).cross(middle[2] - middle[0]).dot(outwards) < 0)
      std::swap(face[1], face[2]);
    faces_.push_back(face);
  }

  const Lattice& lattice_;
  std::unordered_map<std::uint64_t, int> vertex_of_edge_;
  std::vector<Vec3> points_;
  std::vector<std::array<int, 3>> faces_;
};

}  // namespace

TriangleMesh isosurface(const FleshField& field, double spacing, int tessellation) {
  Lattice lattice = makeLattice(field, spacing, tessellation);
  sample(field, lattice);
  // Kuhn's six tetrahedra: the ways from one corner of the cube to the opposite one.
  constexpr int WAYS[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  Marcher marcher(lattice);
  const auto [nx, ny, nz] = lattice.size;
  const int step[3] = {1, nx, nx * ny};
  for (int k = 0; k + 1 < nz; ++k)
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i) {
        const int n = lattice.index(i, j, k);
        if (!marcher.isCrossed(n)) continue;
        for (const auto& way : WAYS) {
          std::array<int, 4> tet = {n, n + step[way[0]], 0, n + step[0] + step[1] + step[2]};
          tet[2] = tet[1] + step[way[1]];
          marcher.march(tet);
        }
      }
  return marcher.mesh();
}

}  // namespace posture::synthesis
