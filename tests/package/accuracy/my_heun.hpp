// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <odeum/kernel/explicit_rk.hpp>
#include <odeum/kernel/method.hpp>
#include <odeum/tableau/order_conditions.hpp>

/// A method in the form of Odeum's own: a tableau, proven when it is compiled.
inline constexpr odeum::Tableau<2> heun_tableau{
    .a = {{{0, 0}, {1, 0}}}, .b = {0.5, 0.5}, .order = 2};
static_assert(odeum::proven<heun_tableau>());

struct my_heun : odeum::ForAnyProblem, odeum::ExplicitRungeKuttaMethod<heun_tableau> {
  static constexpr odeum::MethodInfo info{
      .id = "my_heun", .family = "explicit_rk", .order = 2, .source = "Heun 1900"};
};
