// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <numbers>

#include "odeum/kernel/additive_rk.hpp"

namespace odeum::methods {

/// The additive method of Ascher, Ruuth and Spiteri whose implicit half is the L-stable SDIRK
/// method of two stages; each half has weights of its own.
inline constexpr AdditiveTableau<3> ars222_tableau = [] {
  constexpr double gamma = 1 - std::numbers::sqrt2 / 2, delta = -std::numbers::sqrt2 / 2;
  AdditiveTableau<3> t;
  t.explicit_half = {.a = {{{0, 0, 0}, {gamma, 0, 0}, {delta, 1 - delta, 0}}},
                     .b = {delta, 1 - delta, 0}};
  t.implicit_half = {.a = {{{0, 0, 0}, {0, gamma, 0}, {0, 1 - gamma, gamma}}},
                     .b = {0, 1 - gamma, gamma}};
  t.order = 2;
  return t;
}();
static_assert(proven<ars222_tableau>());

struct ars222 : ForSplit, AdditiveMethod<ars222_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "ars222",
       .source = "Ascher, Ruuth, Spiteri, Appl. Numer. Math. 25 (1997) 151-167, section 2.6"});
};

}  // namespace odeum::methods
