// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>
#include <posture/refine/surface.h>

#include <vector>

namespace posture {

/// `marked`, and what is apart already. \return  whether that is more than what is apart.
bool addApart(std::vector<char>& marked, const std::vector<char>& apart);

/// Where nothing is apart, no list of that is kept (BentPair).
void dropIfNothingIsApart(BentPair& pair);

/// Where a surface comes to lie when what is marked goes as the surface around it does.
/// \param bent  its vertices, as far as they are not marked.
Points placesAnew(const BendableSurface& a,
                  const std::vector<char>& marked,
                  double softness,
                  const Points& bent);

/// The pair with what is marked laid as the surface around it goes, after which both settle: what
/// then lies on the other surface is matched with that, the rest is apart.
/// \param of_a, of_b  vertices of each.
/// \param softness  as for anneal().
BentPair laidAnew(const SpectralSurface& a,
                  const SpectralSurface& b,
                  const std::vector<char>& of_a,
                  const std::vector<char>& of_b,
                  double softness,
                  const BentPair& pair);

}  // namespace posture
