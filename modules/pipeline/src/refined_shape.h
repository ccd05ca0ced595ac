// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/deformation/reduce_mesh.h>
#include <posture/pipeline/observer.h>
#include <posture/refine/sample_maps.h>
#include <posture/refine/surface.h>

#include <string>
#include <vector>

namespace posture {

/// One side of the refined method at its three resolutions.
struct RefinedShape {
  TriangleMesh full;
  ReducedMesh work;      ///< of `full`: where maps are refined
  ReducedMesh coarse;    ///< of `work`: where candidates are compared
  SpectralBasis basis;   ///< on `work`
  SampledShape samples;  ///< on `work`
  double stress = 0;     ///< of the samples' canonical form

  SpectralSurface workSurface() const;
  SpectralSurface coarseSurface() const;
  Eigen::MatrixXf coarseFunctions() const;
};

/// Reduces the mesh. \throws InputError  too few vertices to tell a shape; names the side.
RefinedShape reduceSide(const std::string& side, const TriangleMesh& full);

void addSpectrum(RefinedShape& shape);
void addSamples(RefinedShape& shape);

/// The shape with every length multiplied.
RefinedShape rescaled(RefinedShape shape, double scale);

/// The ratio of distances on b to those on a, the median over pairs of samples whose paths meet no
/// hole. \param map  any map that keeps distances, mirrored or not.
double distanceRatio(const SampledShape& a, const SampledShape& b, const SampleMap& map);

}  // namespace posture
