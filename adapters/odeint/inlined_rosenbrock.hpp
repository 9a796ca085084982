// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include "odeint/catalogue.hpp"
#include "odeint/implicit.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::adapters::odeint {

// See odeint/rosenbrock.hpp, which needs units of plain C++17: cases/inlined/rosenbrock4_runs.cpp.
template <class P>
Outcome run_bare_rosenbrock4(const OdeView& view, double t0, const std::vector<double>& y0,
                             const Request& request);
template <class P>
Outcome run_bare_rosenbrock4_dense_output(const OdeView& view, double t0,
                                          const std::vector<double>& y0, const Request& request);

}  // namespace odeum::adapters::odeint

namespace odeum::cases::inlined {

/// Appends odeint's rosenbrock4 with its right-hand side inlined, where the case has problem P.
template <Ode P>
void add_rosenbrock4(const Case& c, std::vector<Entrant>& all) {
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
  add("rosenbrock4", adapters::odeint::run_bare_rosenbrock4<P>);
  add("rosenbrock4_dense_output", adapters::odeint::run_bare_rosenbrock4_dense_output<P>);
}

}  // namespace odeum::cases::inlined
