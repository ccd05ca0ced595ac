// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/pipeline/observer.h>

#include <array>
#include <string>
#include <vector>

namespace posture {

/// How the winning candidate is chosen.
enum class Method {
  ORIENTED,  ///< the least deformed of the candidates that do not turn the surface inside out
  PAPER      ///< the least deformed, as published: mirrored maps of symmetric bodies often win
};

struct RegistrationOptions {
  Method method = Method::ORIENTED;
};

enum class Status {
  REGISTERED,
  UNDECIDED  ///< the data do not decide; the message says why, and the best guess is still there
};

struct StageTiming {
  std::string stage;
  double seconds = 0;
};

/// One of the 2^k alignments with its figures; lengths in the target's unit.
struct HypothesisSummary {
  std::array<int, 3> axis_signs{};  ///< +1 or -1 per axis of the canonical frame
  double assignment_cost = 0;       ///< E_H of section 4.1
  int matched_samples = 0;          ///< by the assignment
  double consistency = 0;           ///< mean of the matrix C, in [0, 1] (section 4.2)
  int kernel_samples = 0;           ///< left by the consistency kernel (section 4.2)
  int accepted_vertices = 0;        ///< of the source's main surface, with a dense match
  int common_vertices = 0;          ///< of the common meshes
  double source_energy = 0;         ///< E(M0) of section 5.2
  double target_energy = 0;         ///< E(M1)
  double energy = 0;                ///< E_D = max of both; infinity: no common mesh
  double orientation = 0;           ///< vote in [-1, 1]; below 0: the surface inside out
  std::vector<int> target_vertex;   ///< per source vertex as given; -1: rejected
};

/// What was done to one side.
struct ShapeSummary {
  int vertices = 0;  ///< as given
  int faces = 0;
  CleaningSummary cleaning;
  int clean_vertices = 0;
  int boundary_edges = 0;
  double area = 0;  ///< of the main surface, in squared units of the input
  double mean_edge_length = 0;
  int samples = 0;
  double stress = 0;  ///< of the canonical form: sqrt(sum w (d - delta)^2 / sum w delta^2)
};

struct RegistrationResult {
  Status status = Status::UNDECIDED;
  std::string message;
  Correspondence correspondence;
  Points deformed;  ///< n x 3: the source's vertices, as given, moved onto the target
  std::vector<HypothesisSummary> hypotheses;
  int chosen = -1;                   ///< index into hypotheses
  double consistency_threshold = 0;  ///< c0 of section 4.2
  double scale = 1;                  ///< a source length times this is a target length
  ShapeSummary source, target;
  std::vector<StageTiming> timings;
};

/// Finds the dense correspondence of two meshes by the method of Wuhrer, Shu and Bose 2009,
/// sections 4 and 5, and keeps the outside out unless asked for the published choice.
/// \throws InputError  one of the meshes has no surface to work on; names which.
RegistrationResult registerShapes(const TriangleMesh& source,
                                  const TriangleMesh& target,
                                  const RegistrationOptions& options = {},
                                  const Observer& observer = {});

}  // namespace posture
