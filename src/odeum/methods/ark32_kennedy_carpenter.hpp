// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/additive_rk.hpp"

namespace odeum::methods {

/// Kennedy and Carpenter's ARK3(2)4L[2]SA: the implicit half is L-stable and stiffly accurate with
/// stages of order 2, and both halves share their weights.
inline constexpr AdditiveTableau<4> ark32_kennedy_carpenter_tableau = [] {
  constexpr double gamma = 1767732205903. / 4055673282236;
  constexpr std::array<double, 4> b{1471266399579. / 7840856788654, -4482444167858. / 7529755066697,
                                    11266239266428. / 11593286722821, gamma};
  constexpr std::array<double, 4> b_hat{
      2756255671327. / 12835298489170, -10771552573575. / 22201958757719,
      9247589265047. / 10645013368117, 2193209047091. / 5459859503100};
  AdditiveTableau<4> t;
  t.explicit_half = {.a = {{{0, 0, 0, 0},
                            {1767732205903. / 2027836641118, 0, 0, 0},
                            {5535828885825. / 10492691773637, 788022342437. / 10882634858940, 0, 0},
                            {6485989280629. / 16251701735622, -4246266847089. / 9704473918619,
                             10755448449292. / 10357097424841, 0}}},
                     .b = b,
                     .b_hat = b_hat};
  t.implicit_half = {
      .a = {{{0, 0, 0, 0},
             {gamma, gamma, 0, 0},
             {2746238789719. / 10658868560708, -640167445237. / 6845629431997, gamma, 0},
             b}},
      .b = b,
      .b_hat = b_hat};
  t.order = 3;
  t.order_hat = 2;
  return t;
}();
static_assert(proven<ark32_kennedy_carpenter_tableau>());

struct ark32_kennedy_carpenter : ForSplit, AdditiveMethod<ark32_kennedy_carpenter_tableau> {
  static constexpr MethodInfo info =
      described({.id = "ark32_kennedy_carpenter",
                 .control = Control::predictive,
                 .source = "Kennedy, Carpenter, Appl. Numer. Math. 44 (2003) 139-181, "
                           "tables for ARK3(2)4L[2]SA"});
};

}  // namespace odeum::methods
