// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <numbers>

#include "odeum/kernel/diagonally_implicit_rk.hpp"

namespace odeum::methods {

/// A trapezoidal step to t + (2 - sqrt 2) h, then BDF2: L-stable, one factorisation for both. The
/// embedded row has order 3 and is not A-stable; it only estimates the error.
inline constexpr double tr_bdf2_d = 1 - std::numbers::sqrt2 / 2;
inline constexpr double tr_bdf2_w = std::numbers::sqrt2 / 4;
inline constexpr Tableau<3> tr_bdf2_tableau{
    .a = {{{0, 0, 0}, {tr_bdf2_d, tr_bdf2_d, 0}, {tr_bdf2_w, tr_bdf2_w, tr_bdf2_d}}},
    .b = {tr_bdf2_w, tr_bdf2_w, tr_bdf2_d},
    .order = 2,
    .b_hat = {(1 - tr_bdf2_w) / 3, (3 * tr_bdf2_w + 1) / 3, tr_bdf2_d / 3},
    .order_hat = 3,
};
static_assert(proven<tr_bdf2_tableau>());

struct tr_bdf2 : ForAnyProblem, DiagonallyImplicitMethod<tr_bdf2_tableau> {
  static constexpr MethodInfo info =
      described({.id = "tr_bdf2",
                 .control = Control::predictive,
                 .source = "Bank et al., IEEE Trans. CAD 4 (1985) 436-451; Hosea, "
                           "Shampine, Appl. Numer. Math. 20 (1996) 21-37"});
};

}  // namespace odeum::methods
