// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>

namespace posture {

/// A whole source, deformed onto its target.
struct Completion {
  Points places;     ///< n x 3, in the target's frame and unit
  double scale = 1;  ///< a source length times this is a target length
};

/// Deforms the whole source so that it goes through the known matches (section 6.2), by least
/// squares over all vertices p_i:
///   1     sum over edges     ((|p_i - p_j|^2 / l_ij^2 - 1) / 2)^2   l_ij lengths at rest
///   1     sum over vertices  |r_i|^2 / s_i^2                        mean-value encoding
///   0.1   sum over vertices  g_i (n_i . (p_i - t_i))^2 / h^2        distance from the target
///   0.06  sum over matches   c_i b_i |p_i - m_i|^2 / h^2            m_i the match, c_i confidence
/// with h the target's mean edge length. The first is the isometric energy of Kilian, Mitra and
/// Pottmann (2007); r_i and s_i are those of MeanValueEncoding. Places t_i on the target are looked
/// for anew several times; past the rim of a hole there is none, and matches on the rim of a hole
/// do not count, as they may stand for any place in it. g_i is small for places several edges off,
/// where the target has no surface, b_i for matches that lie far from where the rest of the surface
/// wants the vertex (both Geman and McClure). Edges shorter than a tenth of the mean count less,
/// and s_i is no less than that: what is far smaller than the mesh is not worth its stiffness. Over
/// the first half of the rounds the second sum falls from ten times its weight, which opens folds.
/// Meshes of more than 7,500 vertices are laid on 5,000 first.
///
/// \param source   connected.
/// \param start    n x 3, a rough deformation onto the target: nothing here finds its way round a
///        body.
/// \param matches  of the source's vertices, with faces and vertices of `target`; vertex -1: none.
/// \throws std::invalid_argument  sizes or numbers out of range, meshes without faces; as
///         encodeMeanValues() of the source.
Completion completeDeformation(const TriangleMesh& source,
                               const Points& start,
                               const Correspondence& matches,
                               const TriangleMesh& target);

}  // namespace posture
