// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/point_cloud.h>
#include <posture/core/types.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/denoise.h>
#include <posture/pipeline/observer.h>
#include <posture/scan/reconstruct.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace posture {

enum class Method {
  REFINED,  ///< candidates refined to a precise map, the right side chosen among them
  PAPER     ///< as published: good to a few edges, mirrored maps of symmetric bodies often win
};

struct RegistrationOptions {
  Method method = Method::REFINED;
  /// REFINED: also take the answers that were not chosen to full precision.
  bool refine_alternatives = false;
  bool both_ways = false;  ///< REFINED: also the way back, from the target to the source
  /// How a surface is laid through the points of a cloud.
  SurfaceMethod surface = SurfaceMethod::TANGENT_DELAUNAY;
};

enum class Status {
  REGISTERED,
  UNDECIDED  ///< the data do not decide; the message says why, and the best guess is still there
};

struct StageTiming {
  std::string attempt;  ///< as in StageEvent
  std::string stage;
  double seconds = 0;
};

/// PAPER: one of the 2^k alignments with its figures; lengths in the target's unit.
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
  std::vector<int> target_vertex;   ///< per source vertex as given; -1: rejected
};

/// REFINED: one of the different answers that were compared. The terms of the score are those of
/// MapScore, on coarse meshes; lower is better.
struct AlternativeSummary {
  double orientation = 0;  ///< in [-1, 1]; 1: the outside stays out. Of the candidate it began as;
                           ///< of the map itself if that was changed before it was bent
  double bending = 0;
  double curvature = 0;
  double distortion = 0;
  double return_miss = 0;
  double let_go = 0;
  double score = 0;
  /// That of the map refined from it, with what it pays for hands on the other side, and by how
  /// much worse ends of limbs fit than under the others (endDisagreements()); none where another
  /// answer is better by far before that.
  std::optional<double> refined_score;
  double gap = 0;                  ///< mean distance from the chosen answer, over sqrt(area)
  std::vector<int> target_vertex;  ///< per source vertex as given, to the spacing of the coarse
                                   ///< meshes; also where the target has a hole; -1: on a patch, on
                                   ///< a floor or wall, and for points that are missing or outliers
  Correspondence correspondence;   ///< at full precision; empty unless alternatives are refined
};

/// What was done to one side.
struct ShapeSummary {
  int vertices = 0;  ///< as given
  int faces = 0;
  Denoising denoising;  ///< of a mesh; the surface of a cloud is of denoised points
  /// Of a floor, a table, a wall behind the body, that were left out: see backgroundFaces().
  int background_faces = 0;
  CleaningSummary cleaning;
  int clean_vertices = 0;
  int boundary_edges = 0;
  /// Closed while maps were sought, as the surface goes on across them; those cut along contacts
  /// too.
  int patched_holes = 0;
  int joined_pieces = 0;    ///< across narrow gaps, to the main surface
  int parted_contacts = 0;  ///< where it was taken for grown together with itself, and cut open
  int added_vertices = 0;   ///< on long edges while maps were sought: the other side is much finer
  double area = 0;          ///< of the main surface, in squared units of the input
  double left_out_share = 0;  ///< over that, the area of the largest other part without a place
  double compared_share = 1;  ///< of the area: less where the other side was taken for a piece
  double mean_edge_length = 0;
  int samples = 0;
  double stress = 0;  ///< of the canonical form: sqrt(sum w (d - delta)^2 / sum w delta^2)
};

/// The map from the target to the source, found together with the one there.
struct WayBack {
  Correspondence correspondence;  ///< one row per target vertex (point) as given
  /// Of source vertices on the main surface that have both ways: how far from the vertex the way
  /// there and back ends, straight, over the square root of the area of the source's surface that
  /// was compared; 0 where there are none.
  double mean_miss = 0, percentile_95_miss = 0;
};

struct RegistrationResult {
  Status status = Status::UNDECIDED;
  std::string message;
  Correspondence correspondence;
  Points deformed;  ///< n x 3: the source's vertices, denoised, or points moved onto the target
  std::optional<WayBack> back;                   ///< if asked for
  std::vector<HypothesisSummary> hypotheses;     ///< PAPER
  std::vector<AlternativeSummary> alternatives;  ///< REFINED, by increasing score
  int chosen = -1;                               ///< index into hypotheses or alternatives
  double consistency_threshold = 0;              ///< PAPER: c0 of section 4.2
  /// REFINED: of the map that was chosen, before it is annealed, as its rivals'; with `hands`.
  double score = 0;
  double hands = 0;  ///< REFINED: what of the score the map pays for hands on the other side
  double trust = 0;  ///< REFINED, 0 to 1: how likely the map is right, see docs/decisions/trust.md
  double scale = 1;  ///< a source length times this is a target length
  ShapeSummary source, target;  ///< of the meshes, given or laid through the points
  /// The vertices of a side that was a mesh, as they were registered, where denoising moved any;
  /// 0 x 3 otherwise.
  Points source_denoised, target_denoised;
  /// Where a side was a point cloud: the surface laid through it, which faces refer to.
  std::optional<ScanSurface> source_scan, target_scan;
  Points surface_deformed;  ///< the vertices of source_scan's mesh, moved onto the target
  std::vector<StageTiming> timings;
};

/// The rows of the correspondence whose vertices or points are there: all but missing points.
inline long presentCount(const RegistrationResult& result) {
  const auto rows = static_cast<long>(result.correspondence.on_target.size());
  return result.source_scan ? rows - result.source_scan->summary.missing : rows;
}

/// Of these, those with a counterpart; NaN where there are none.
inline double mappedShare(const RegistrationResult& result) {
  return static_cast<double>(mappedCount(result.correspondence.on_target)) /
         static_cast<double>(presentCount(result));
}

/// The vertices of a mesh as they were registered; the points of a cloud.
/// \param denoised  of this side, in the result.
inline const Points& registeredPoints(const Shape& given, const Points& denoised) {
  return denoised.rows() > 0 ? denoised : given.cloud.points;
}

/// The mesh of a side as it was registered, given or laid through the points.
/// \param scan, denoised  of this side, in the result.
inline TriangleMesh registeredMesh(const Shape& given,
                                   const std::optional<ScanSurface>& scan,
                                   const Points& denoised) {
  return scan ? scan->mesh : TriangleMesh{registeredPoints(given, denoised), given.faces};
}

/// Finds the dense correspondence of two meshes.
/// \throws InputError  one of the meshes has no surface to work on; std::invalid_argument  as
/// requireMesh(), which a vertex that is not finite is, too: messages of both begin with the side,
/// "source" or "target"; TornSurface (deformation/arap.h)  a mesh is so torn that it cannot be
/// bent.
RegistrationResult registerShapes(const TriangleMesh& source,
                                  const TriangleMesh& target,
                                  const RegistrationOptions& options = {},
                                  const Observer& observer = {});

/// The same for meshes and point clouds, any mix. The correspondence has a row for each point of
/// the source, in order, and points of the target as vertices; a point that is missing, or taken
/// for an outlier, has no counterpart.
/// \throws as above, and as reconstruct().
RegistrationResult registerShapes(const Shape& source,
                                  const Shape& target,
                                  const RegistrationOptions& options = {},
                                  const Observer& observer = {});

}  // namespace posture
