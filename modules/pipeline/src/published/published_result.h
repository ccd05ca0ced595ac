// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/dense/dense_map.h>
#include <posture/pipeline/register_shapes.h>

#include "published/hypothesis.h"
#include "sides/given_shape.h"
#include <vector>

namespace posture {

/// One side on its way through the pipeline.
struct Side {
  const GivenShape& given;
  const EmbeddedShape& shape;
};

/// Everything in terms of the vertices as they were given.
RegistrationResult publishedResult(const Side& source,
                                   const Side& target,
                                   const std::vector<Hypothesis>& hypotheses,
                                   int chosen,
                                   double scale);

}  // namespace posture
