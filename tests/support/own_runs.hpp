// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/solvers/own_methods.hpp"

/// Own methods on problems of the tests' own, through the catalogue: nothing is compiled anew.
namespace odeum::tests {

/// A problem, which has to outlive every solve, with its initial state.
template <Ode P>
ErasedContest contest_on(const P& problem, double t0, std::vector<double> y0) {
  return {view_of(problem), nullptr, t0, std::make_shared<const std::vector<double>>(std::move(y0)),
          nullptr};
}

/// Runs the method of that id; throws where there is none or it does not fit.
inline Outcome run_own(std::string_view id, const ErasedContest& contest, const Request& request) {
  for (const Solver& method : own_methods()) {
    if (method.info.method != id) continue;
    Entrant entrant;
    method.enroll(contest, entrant);
    if (!entrant.solve) throw std::runtime_error(std::string(id) + " " + entrant.unfit);
    return entrant.solve(request);
  }
  throw std::runtime_error("no method " + std::string(id));
}

}  // namespace odeum::tests
