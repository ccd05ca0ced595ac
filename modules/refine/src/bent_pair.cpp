// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/bent_pair.h>

namespace posture {

BentPair reversed(const BentPair& pair) {
  return {{pair.maps.backward, pair.maps.forward},
          pair.bent_b,
          pair.bent_a,
          pair.apart_b,
          pair.apart_a};
}

}  // namespace posture
