// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/deformation/reduce_mesh.h>
#include <posture/mesh/split_long_edges.h>
#include <posture/refine/sample_maps.h>
#include <posture/refine/settle.h>
#include <posture/refine/surface.h>
#include <posture/spectral/spectral_basis.h>

#include <string>
#include <vector>

namespace posture {

/// One side of the refined method at its three resolutions.
struct RefinedShape {
  TriangleMesh full;  ///< the main surface; where it is too coarse, with more vertices on it, which
                      ///< come after its own
  std::vector<FacePart> parts;  ///< faces of `full` in those of the main surface; empty: the same
  ReducedMesh work;             ///< of `full`: where maps are refined
  ReducedMesh coarse;           ///< of `work`: where candidates are compared
  SpectralBasis basis;          ///< on `work`
  SampledShape samples;         ///< on `work`
  std::vector<int> sample_vertex;  ///< each sample's vertex of `work`
  double stress = 0;               ///< of the samples' canonical form

  /// A place on `full` as one on the main surface.
  FacePoint onMainSurface(const FacePoint& place) const;

  /// The ends of limbs, vertices of `work`.
  std::vector<int> tips() const;

  SpectralSurface workSurface() const;
  SpectralSurface coarseSurface() const;
  Eigen::MatrixXf coarseFunctions() const;
};

/// Whether maps from the one surface to the other are held back by how few vertices it has.
bool isMuchCoarser(const TriangleMesh& surface, const TriangleMesh& other);

/// A side with its main surface alone, which gets more vertices if it is too coarse.
/// \throws InputError  too few vertices to tell a shape; names the side.
RefinedShape fullSide(const std::string& side, const TriangleMesh& surface, bool too_coarse);

/// Adds the meshes a side is worked on.
/// \param others  vertices of the other side.
/// \throws InputError  it falls apart on fewer vertices; names the side.
void reduceSide(const std::string& side, int others, RefinedShape& shape);

/// Both: \throws InputError  it cannot be computed of this side, which is named.
void addSpectrum(const std::string& side, RefinedShape& shape);
void addSamples(const std::string& side, RefinedShape& shape);

/// The shape with every length multiplied.
RefinedShape rescaled(RefinedShape shape, double scale);

/// The ratio of distances on b to those on a: the median over pairs of samples, each counted by the
/// confidence in both distances, little where paths meet a hole. \param map  any map that keeps
/// distances, mirrored or not.
double distanceRatio(const SampledShape& a, const SampledShape& b, const SampleMap& map);

}  // namespace posture
