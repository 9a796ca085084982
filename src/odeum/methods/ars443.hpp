// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/additive_rk.hpp"

namespace odeum::methods {

/// The additive method of Ascher, Ruuth and Spiteri with four implicit stages, whose implicit half
/// is L-stable and stiffly accurate; each half has weights of its own.
inline constexpr AdditiveTableau<5> ars443_tableau{
    .explicit_half = {.a = {{{0},
                             {1. / 2},
                             {11. / 18, 1. / 18},
                             {5. / 6, -5. / 6, 1. / 2},
                             {1. / 4, 7. / 4, 3. / 4, -7. / 4}}},
                      .b = {1. / 4, 7. / 4, 3. / 4, -7. / 4, 0}},
    .implicit_half = {.a = {{{0},
                             {0, 1. / 2},
                             {0, 1. / 6, 1. / 2},
                             {0, -1. / 2, 1. / 2, 1. / 2},
                             {0, 3. / 2, -3. / 2, 1. / 2, 1. / 2}}},
                      .b = {0, 3. / 2, -3. / 2, 1. / 2, 1. / 2}},
    .order = 3,
};
static_assert(proven<ars443_tableau>());

struct ars443 : ForSplit, AdditiveMethod<ars443_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "ars443",
       .source = "Ascher, Ruuth, Spiteri, Appl. Numer. Math. 25 (1997) 151-167, section 2.8"});
};

}  // namespace odeum::methods
