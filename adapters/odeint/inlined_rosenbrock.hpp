// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include "odeint/catalogue.hpp"
#include "odeint/implicit.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases::inlined {

/// Appends odeint's rosenbrock4, whose units are plain C++17, where the case has problem P.
/// `controlled` and `dense` are runs with its right-hand side inlined (odeint/rosenbrock.hpp).
template <Ode P>
void add_rosenbrock4(const Case& c, std::vector<Entrant>& all,
                     adapters::odeint::ImplicitRun controlled,
                     adapters::odeint::ImplicitRun dense) {
  static_assert(WithJacobian<P> && !NonAutonomous<P>);
  if (c.problem.view.rhs != view_of(P{}).rhs) return;
  const auto problem = std::make_shared<const P>(*static_cast<const P*>(c.problem.view.problem));
  const auto add = [&](std::string_view method, adapters::odeint::ImplicitRun run) {
    all.push_back({.info = adapters::odeint::info_of(method),
                   .unfit = {},
                   .solve = [run, problem, t0 = c.t0, y0 = c.problem.y0](const Request& request) {
                     return run(view_of(*problem), t0, *y0, request);
                   }});
  };
  add("rosenbrock4", controlled);
  add("rosenbrock4_dense_output", dense);
}

}  // namespace odeum::cases::inlined
